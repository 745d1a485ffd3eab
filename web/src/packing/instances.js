/** What drawings of many equal squares on the graphics card have alike: each is four corners, placed by numbers of its
    own (`own`: attributes of an instance, those of bytes as colours), and smooth at its edge over what is below. */
export const instances = (regl, corner, own) => ({
  attributes: {
    corner,
    ...Object.fromEntries(
      Object.entries(own).map(([name, of]) => [
        name,
        { buffer: regl.prop(name), divisor: 1, ...(of === "bytes" && { type: "uint8", normalized: true }) },
      ]),
    ),
  },
  primitive: "triangle strip",
  count: 4,
  instances: regl.prop("count"),
  depth: { enable: false },
  blend: {
    enable: true,
    func: { srcRGB: "src alpha", srcAlpha: "one", dstRGB: "one minus src alpha", dstAlpha: "one" },
  },
});
