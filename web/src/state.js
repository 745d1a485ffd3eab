/** What the reader has chosen; everything that is drawn follows from it and from the data. */
export class State {
  #values;
  #watchers = [];

  constructor(values) {
    this.#values = values;
  }

  get(name) {
    return this.#values[name];
  }

  /** Changes some values and tells those who watch any of them. */
  set(changes) {
    const changed = Object.keys(changes).filter((name) => this.#values[name] !== changes[name]);
    if (changed.length === 0) return;
    Object.assign(this.#values, changes);
    for (const { names, then } of this.#watchers) if (names.some((name) => changed.includes(name))) then();
  }

  watch(names, then) {
    this.#watchers.push({ names, then });
  }
}
