/** The source's figure, what is said of ours and of its scatter, and what of it is not there yet. */
export function captionOf({ source, caption, spread, missing, sample }) {
  const said = [
    source,
    caption?.replace(/\.$/, ""),
    spread,
    sample && `${Number(sample.size[0].toPrecision(3))} mm across`,
  ]
    .filter(Boolean)
    .join(". ");
  return [said && `${said}.`, missing].filter(Boolean).join(" ");
}
