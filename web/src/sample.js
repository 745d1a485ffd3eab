import { opened, unpacked } from "./block.js";
import { finders } from "./packing/finders.js";
import { text } from "./text.js";

const aroundFailure = 0.08; // of a sample's longer side

const leftOutWhereZero = ["pressure", "deviator", "vx", "vy", "omega", "displacement", "rotation"];

/** The data of the page: grains, materials, stages and snapshots; arrays of a snapshot are unpacked when first asked
    for. */
export class Sample {
  #block;
  #snapshots = new Map();

  constructor(about, block) {
    this.#block = block;
    this.about = about;
    this.title = about.title;
    this.materials = about.materials ?? [];
    // Figures when they are first drawn.
    this.stages = about.stages.map(({ figures: _, ...stage }) => unpacked(block, stage));
    this.snapshotCount = about.snapshots.length;
    this.count = about.grains?.count ?? 0;
    const { id, radius, material, zone, shapes } = unpacked(block, about.grains ?? {});
    Object.assign(this, { id, radius, material, zone, shapes });
    this.types = contactTypes(this.materials);
    this.meanRadius = about.grains?.mean_radius || 1;
    this.materialCounts = this.materials.map((_, m) =>
      this.count ? this.material.reduce((sum, other) => sum + (other === m), 0) : 0,
    );
    this.exchanges = about.snapshots.some(({ present }) => present);
    this.hasZones = this.count > 0 && this.zone.some((z) => z > 0);
  }

  /** What a figure shows of the run as a whole; undefined where that is nothing. */
  ofRun(id) {
    return opened(this.#block, this.about.run ? { figures: this.about.run } : null, id);
  }

  /** What a figure shows of the state shown, of its stage, or with `nearest` of the next stage that has it, or of the
      whole run, the state's place in it (null: not in it), and the first state that has a place in it; null where there
      is nothing. */
  drawn(id, state, nearest = false) {
    const k = state.get("snapshot"),
      { snapshots, stages, run } = this.about,
      { stage } = snapshots[k];
    const firstOf = (s) => snapshots.findIndex((snapshot) => snapshot.stage === s),
      near = nearest ? stages.indexOf(this.#stageNear(stage, id)) : -1;
    const places = [
      [run, 0],
      [snapshots[this.texture(k)?.snapshot], k],
      [stages[stage], firstOf(stage)],
      [stages[near], firstOf(near)],
    ];
    for (const [part, first] of places) {
      const drawings = opened(this.#block, part === run ? { figures: run } : part, id);
      if (drawings) return { drawings, here: part === stages[near] && near !== stage ? null : k - first, first };
    }
    return null;
  }

  /** The last stage before that one in which a figure has something to show, or else the first after it. */
  #stageNear(stage, id) {
    const { stages } = this.about;
    return [...stages.slice(0, stage).reverse(), ...stages.slice(stage)].find(({ figures }) => figures[id]);
  }

  /** Whether a figure has anything to show of the last state, of any stage, or of the run. */
  hasDrawn(id) {
    const { snapshots, stages, run } = this.about,
      last = snapshots[this.texture(this.snapshotCount - 1)?.snapshot];
    return Boolean(run?.[id] ?? last?.figures[id] ?? stages.find(({ figures }) => figures[id]));
  }

  snapshot(k) {
    if (!this.#snapshots.has(k)) {
      if (this.#snapshots.size > 24) this.#snapshots.clear();
      this.#snapshots.set(k, this.#unpackSnapshot(k));
    }
    return this.#snapshots.get(k);
  }

  #unpackSnapshot(k) {
    const { texture = null, fields: _, figures: __, ...about } = this.about.snapshots[k];
    const snapshot = { ...spread(unpacked(this.#block, about), this.count), index: k, texture };
    for (const name of leftOutWhereZero) snapshot[name] ??= new Float32Array(this.count);
    for (const name of ["fn", "ft"]) snapshot.contacts[name] ??= new Float32Array(snapshot.contacts.i.length);
    snapshot.boundaries = snapshot.domain.boundaries ?? [];
    snapshot.contacts.type = this.#typesOf(snapshot.contacts);
    snapshot.meanForce = snapshot.force_scale.mean;
    snapshot.tensile = snapshot.force_scale.tension;
    snapshot.hasTension = snapshot.contacts.fn.some((force) => force < snapshot.tensile);
    snapshot.sigmaNorm = snapshot.sigma_norm;
    return snapshot;
  }

  /** The texture that belongs to a snapshot: its own, or else that of the nearest snapshot that has one. */
  texture(k) {
    const known = this.about.snapshots.map((snapshot, f) => (snapshot.texture ? f : -1)).filter((f) => f >= 0);
    if (known.length === 0) return null;
    const nearest = known.reduce((best, f) => (Math.abs(f - k) < Math.abs(best - k) ? f : best));
    return { ...this.about.snapshots[nearest].texture, snapshot: nearest };
  }

  /** The coarse-grained fields of a snapshot, or of the nearest that has them; null where none has. */
  fields(k) {
    const known = this.about.snapshots.map((snapshot, f) => (snapshot.fields ? f : -1)).filter((f) => f >= 0);
    if (known.length === 0) return null;
    const nearest = known.reduce((best, f) => (Math.abs(f - k) < Math.abs(best - k) ? f : best)),
      about = this.about.snapshots[nearest],
      size = about.fields.columns * about.fields.rows;
    return (about.unpackedFields ??= { ...unpacked(this.#block, about.fields), size, snapshot: nearest });
  }

  #typesOf({ i, j }) {
    const code = new Uint8Array(i.length);
    const wall = this.types.length - 1;
    const table = this.materials.map(() => []);
    this.types.forEach((type, t) => {
      if (!type.wall) table[type.a][type.b] = table[type.b][type.a] = t;
    });
    for (let c = 0; c < i.length; ++c)
      code[c] = j[c] >= this.count ? wall : table[this.material[i[c]]][this.material[j[c]]];
    return code;
  }

  /** Contacts of each grain as a list in rows: contacts of grain g are list[start[g]] .. list[start[g + 1] - 1]. */
  contactsByGrain(snapshot) {
    if (snapshot.byGrain) return snapshot.byGrain;
    const { i, j } = snapshot.contacts;
    const start = new Uint32Array(this.count + 1);
    for (let c = 0; c < i.length; ++c) {
      ++start[i[c] + 1];
      if (j[c] < this.count) ++start[j[c] + 1];
    }
    for (let g = 0; g < this.count; ++g) start[g + 1] += start[g];
    const list = new Uint32Array(start[this.count]);
    const next = start.slice();
    for (let c = 0; c < i.length; ++c) {
      list[next[i[c]]++] = c;
      if (j[c] < this.count) list[next[j[c]]++] = c;
    }
    return (snapshot.byGrain = { start, list });
  }

  /** The box that holds what is to be seen of all states of a snapshot's stage, so that the picture stands still while
      they pass; of a sample that failed that of the states until then and a margin, for its pieces fly far. */
  extent(k) {
    const { stage } = this.about.snapshots[k],
      { opens } = this.stages[stage],
      boxes = this.about.snapshots.filter((snapshot) => snapshot.stage === stage).map(({ extent }) => extent);
    const [left, right, bottom, top] = [Math.min, Math.max, Math.min, Math.max].map((end, side) =>
      end(...boxes.slice(0, opens === undefined ? boxes.length : opens + 1).map((box) => box[side])),
    );
    const margin = opens === undefined ? 0 : aroundFailure * Math.max(right - left, top - bottom);
    return { left: left - margin, right: right + margin, bottom: bottom - margin, top: top + margin };
  }

  /** The state with which the page opens: the last one, or that of the last stage at which its sample failed. */
  get opening() {
    const last = this.snapshotCount - 1,
      stage = this.about.snapshots[last]?.stage;
    const { opens } = this.stages[stage] ?? {};
    return opens === undefined ? last : this.about.snapshots.findIndex((one) => one.stage === stage) + opens;
  }

  /** Rectangle of the snapshot: what the walls or the periodic cell enclose. */
  box(snapshot) {
    const [left, right, bottom, top] = snapshot.domain.walls.map((wall) => wall.position);
    return { left, right, bottom, top };
  }

  materialName(grain) {
    return text.material(this.materials[this.material[grain]]);
  }

  /** How the numbers of grains are found (quantities.js). */
  get finders() {
    return finders;
  }

  /** What a figure has on its abscissa of a grain, SI: "diameter", or the "sigma_norm" of a texture. */
  abscissaOf(grain, what, texture) {
    return what === "diameter" ? 2 * this.radius[grain] : this.snapshot(texture.snapshot).sigmaNorm[grain];
  }
}

/** Values of the grains of a state at the places that these have among all. */
function placed(values, places, count, fill) {
  const all = new Float64Array(count).fill(fill);
  places.forEach((g, k) => (all[g] = values[k]));
  return all;
}

/** A state in which some of the sample's grains are missing, because they come in later or have left: its values are
    put where its grains stand among all, and what is missing lies nowhere (NaN). */
function spread(snapshot, count) {
  const { present } = snapshot;
  if (!present) return snapshot;
  const spread = { ...snapshot };
  for (const [name, values] of Object.entries(snapshot))
    if (name !== "present" && ArrayBuffer.isView(values) && values.length === present.length)
      spread[name] = placed(values, present, count, name === "x" || name === "y" ? NaN : 0);
  const place = (g) => (g < present.length ? present[g] : g - present.length + count);
  for (const name of ["contacts", "bonds", "cohesive"]) {
    const links = snapshot[name];
    if (links) spread[name] = { ...links, i: Uint32Array.from(links.i, place), j: Uint32Array.from(links.j, place) };
  }
  return spread;
}

/** Whether a grain is there in a state. */
export const isPresent = (snapshot, g) => !Number.isNaN(snapshot.x[g]);

function contactTypes(materials) {
  const types = [];
  materials.forEach((_, a) => types.push({ a, b: a }));
  let mixed = 0;
  materials.forEach((_, a) =>
    materials.forEach((__, b) => {
      if (a < b) types.push({ a, b, mixed: mixed++ });
    }),
  );
  for (const type of types) {
    type.label = `${materials[type.a].name}\u2013${materials[type.b].name}`;
    type.key = `${materials[type.a].name}-${materials[type.b].name}`;
  }
  types.push({ wall: true, label: "walls", key: "wall" });
  return types;
}
