import { h, rich } from "./dom.js";
import { prefixOf, text } from "./text.js";

/** The rows of the table of numbers: [group, name, symbol, estimate, unit, scale]. */
function rowsOf(t, sample) {
  const rows = [];
  const add = (group, name, symbol, estimate, unit = "", scale = 1) => {
    if (estimate === undefined || estimate === null) return;
    const { value, error } = typeof estimate === "number" ? { value: estimate, error: null } : estimate;
    if (value === null || value === undefined) return;
    rows.push({ group, name, symbol, value: value * scale, error: error === null || error === undefined ? null : error * Math.abs(scale), unit });
  };
  const bySize = (group, name, symbol, estimate, unit, sign = 1) => {
    if (!estimate) return;
    const { factor, prefix } = prefixOf(Math.abs(estimate.value ?? estimate), unit);
    add(group, name, symbol, estimate, prefix + unit, sign / factor);
  };
  add("Structure", "grains considered", "N_{p}", t.considered?.grains);
  add("Structure", "contacts considered", "N_{c}", t.considered?.contacts);
  add("Structure", "solid fraction", "\u03c6", t.solid_fraction);
  add("Structure", "local order", "\u03c8_{6}", t.local_order?.psi6);
  const z = t.coordination ?? {};
  add("Coordination", "all grains", "z", z.all);
  add("Coordination", "without rattlers", "z", z.without_rattlers);
  for (const m of sample.materials) if (sample.materials.length > 1) add("Coordination", `${m.name}\u2013any`, "z", z[`${m.name}-ANY`]);
  for (const [name, value] of Object.entries(z)) if (/^[^ ]+-(?!ANY)[^ ]+$/.test(name)) add("Coordination", name.replace("-", "\u2013"), "z", value);
  add("Coordination", "rattlers", "", z.rattlers, "%", 100);
  const f = t.fabric;
  if (f) {
    for (const [name, set] of [["all", f], ...Object.entries(f.sets ?? {}).filter(([n]) => !/ (strong|weak)$/.test(n))]) {
      add("Fabric", name.replace("-", "\u2013"), "a_{c}", set.a_c);
      add("Fabric", name.replace("-", "\u2013"), "\u03b8_{c}", set.theta_c_deg, "\u00b0");
    }
    add("Fabric", "mechanical, all", "a_{n}", f.a_n);
  }
  const d = t.stress_details ?? {};
  const sigma = t.stress;
  if (sigma) for (const [symbol, i, j] of [["\u03c3_{xx}", 0, 0], ["\u03c3_{yy}", 1, 1], ["\u03c3_{xy}", 0, 1]])
    bySize("Stress", "of the assembly", symbol, { value: sigma.value[i][j], error: sigma.error?.[i]?.[j] }, "Pa");
  bySize("Stress", "pressure", "p", d.pressure_Pa, "Pa");
  bySize("Stress", "deviator", "q", d.deviator_Pa, "Pa");
  add("Stress", "strong share of the pressure", "", d.strong_share_of_pressure, "%", 100);
  add("Stress", "strong share of the deviator", "", d.strong_share_of_deviator, "%", 100);
  for (const [name, set] of [["all", t.sigma_norm], ...Object.entries(t.sigma_norm?.by_material ?? {})]) {
    if (!set) continue;
    bySize("Grain stress", name, "\u27e8\u03c3_{hyd}\u27e9", set.mean_Pa, "Pa");
    add("Grain stress", name, "P_{0}", set.P0, "%", 100);
    add("Grain stress", name, "\u03b2", set.beta);
  }
  for (const [name, set] of [["all", t.force], ...Object.entries(t.force?.by_type ?? {})]) {
    if (!set) continue;
    const label = name.replace("-", "\u2013");
    bySize("Contact forces", label, "\u27e8F_{n}\u27e9", set.mean_N, "N");
    add("Contact forces", label, "share above the mean", set.strong_share, "%", 100);
    add("Contact forces", label, "\u03b1", set.alpha);
    add("Contact forces", label, "\u03b2", set.beta);
  }
  add("Contact forces", "check", "\u03b2\u00b2/[(1\u2212\u03b1)(2\u2212\u03b1)]", t.force?.beta2_over_product);
  return rows;
}

/** The six numbers that one asks for first. */
export function headlines(sample, state) {
  const box = h("div", { class: "headlines" });
  const refresh = () => {
    const t = sample.texture(state.get("frame"));
    if (!t) return box.replaceChildren();
    const tiles = [
      ["solid fraction", "\u03c6", t.solid_fraction, 1, ""],
      ["coordination", "z", t.coordination?.all, 1, ""],
      ["fabric anisotropy", "a_{c}", t.fabric?.a_c, 1, ""],
      ["grains above the mean stress", "P_{0}", t.sigma_norm?.P0, 100, "%"],
      ["strong contacts", "", t.force?.strong_share, 100, "%"],
      ["mean force", "\u27e8F_{n}\u27e9", t.force?.mean_N, null, "N"],
    ].filter(([, , estimate]) => estimate);
    box.replaceChildren(...tiles.map(([name, symbol, estimate, scale, unit]) => {
      const { factor, prefix } = scale === null ? prefixOf(estimate.value, unit) : { factor: 1 / scale, prefix: "" };
      const { value, error } = text.withError(estimate.value / factor, estimate.error / factor);
      return h("div", { class: "tile" }, h("p", {}, name, symbol && [" ", h("i", {}, rich(symbol))]),
        h("strong", {}, value, h("small", {}, error && ` \u00b1 ${error}`, unit && `\u202f${prefix}${unit}`)));
    }));
  };
  state.watch(["frame"], refresh);
  refresh();
  return box;
}

/** Every number with its standard error and unit, for the state that is shown. */
export function numbersTable(sample, state) {
  const body = h("div", { class: "columns" });
  const refresh = () => {
    const t = sample.texture(state.get("frame"));
    const rows = t ? rowsOf(t, sample) : [];
    const groups = [...new Set(rows.map((r) => r.group))];
    body.replaceChildren(...groups.map((group) => h("table", {},
      h("caption", {}, group),
      h("tbody", {}, rows.filter((r) => r.group === group).map((row) => {
        const { value, error } = row.error > 0 ? text.withError(row.value, row.error) : { value: Number.isInteger(row.value) ? text.count(row.value) : text.number(row.value, 4), error: "" };
        return h("tr", {}, h("td", {}, row.name), h("td", { class: "symbol" }, rich(row.symbol)), h("td", { class: "value" }, value),
          h("td", { class: "error" }, error && `\u00b1 ${error}`), h("td", { class: "unit" }, row.unit));
      })))));
  };
  state.watch(["frame"], refresh);
  refresh();
  return h("section", { class: "card numbers" }, h("div", { class: "title" }, h("h3", {}, "Numbers")), body, notes(sample, state));
}

function notes(sample, state) {
  const list = h("ul", { class: "notes" });
  const refresh = () => list.replaceChildren(...(sample.texture(state.get("frame"))?.notes ?? []).map((note) => h("li", {}, note)));
  state.watch(["frame"], refresh);
  refresh();
  return list;
}
