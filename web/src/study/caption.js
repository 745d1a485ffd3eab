/** The source's figure, what is said of ours, and what of it is not there yet. */
export function captionOf({ source, caption, missing, sample }) {
  const said = [source, caption?.replace(/\.$/, ""), sample && `${Number(sample.size[0].toPrecision(3))} mm across`].filter(Boolean).join(". ");
  return [said && `${said}.`, missing].filter(Boolean).join(" ");
}
