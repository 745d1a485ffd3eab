const operators = {
  "+": (a, b) => a + b,
  "-": (a, b) => a - b,
  "*": (a, b) => a * b,
  "/": (a, b) => a / b,
  hypot: Math.hypot,
  atan2: Math.atan2,
};

/** Names that a formula needs. */
export const namesIn = (formula) => formula.split(" ").filter((word) => isName(word));

const isName = (word) => /^[a-z]/.test(word) && word !== "pi" && !operators[word];
const numberOf = (word) => (word === "pi" ? Math.PI : Number(word));

/** A number that the program says how to form of others: operators stand behind what they act on (core/formula.hpp).
    `of(name)` = a number. */
export function evaluate(formula, of) {
  const stack = [];
  for (const word of formula.split(" ")) {
    const act = operators[word];
    if (act) {
      const right = stack.pop();
      stack.push(act(stack.pop(), right));
    } else stack.push(isName(word) ? of(word) : numberOf(word));
  }
  return stack.pop();
}

/** The same of arrays, element by element. */
export function evaluateAll(formula, size, of) {
  const stack = [];
  for (const word of formula.split(" ")) {
    const act = operators[word];
    if (act) {
      const right = stack.pop(),
        left = stack.pop();
      stack.push(Float64Array.from({ length: size }, (_, k) => act(left[k], right[k])));
    } else stack.push(isName(word) ? of(word) : new Float64Array(size).fill(numberOf(word)));
  }
  return Float32Array.from(stack.pop());
}
