/** The source's figure and what is said of ours. */
export const captionOf = ({ source, caption }) => [source, caption].filter(Boolean).join(". ");
