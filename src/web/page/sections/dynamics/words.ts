/** What is seen, in a sentence or two. */
import type { Launch, Method, Moves } from "./flight";

const turning: Record<Method, string> = {
  published: "The talk’s loop keeps ω. Energy and the size of L stay, but the direction of L goes round, which only a torque could do. A smaller step does not help: the idea is wrong, not the arithmetic.",
  euler: "L is kept, and ω follows from it. But each step goes straight on along the tangent, so energy grows, and the axis tips over until it lies across L. A smaller step only delays it.",
  rk4: "Four looks at the rate in each step. Nothing is kept exactly, but the error goes with the fourth power of the step: halve it, and the error is sixteen times smaller.",
  splitting: "Each step is a few exact rotations about the stone’s own axes. L is kept, and the energy’s error does not grow with time.",
};
const falling: Record<Method, string> = {
  published: "Gravity is added to the velocity before the stone is moved, so the parabola falls behind, by g t Δt/2: half the step, half of that.",
  euler: "Its parabola is the talk’s, which falls behind, by g t Δt/2: half the step, half of that.",
  rk4: "Its parabola is exact in each step, so only rounding parts the two centres.",
  splitting: "Its parabola is exact in each step, so only rounding parts the two centres.",
};

export function says({ moves, method }: Launch): string {
  const parts: Record<Moves, string[]> = {
    rotation: [turning[method]], gravity: [falling[method]], both: [turning[method], falling[method]],
  };
  return parts[moves].join(" ");
}
