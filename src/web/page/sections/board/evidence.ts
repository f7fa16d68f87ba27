/** "Why it is right", as long as the suite has no claims about scenes: what their tests say. */
import { fold } from "../../controls";
import { el } from "../../dom";

/** A test of tests/, and what it shows. */
const statements: readonly (readonly [test: string, sentence: string])[] = [
  ["Scene.OneStoneIsADropToTheLastBit", "A stone that touches no other falls, bounces and rolls as in section 7, to the last bit."],
  ["Scene.ImpactsKeepMomenta", "An impact of two stones keeps their momentum, and their angular momentum."],
  ["Scene.NewtonsCradlePassesItOn", "A row passes a hit on to its last stone."],
  ["Scene.DoesNotDependOnHowTimeIsCut", "How time is cut does not matter, to the last bit: so a slow computer shows the same scene."],
  ["Scene.AHeapComesToRest", "A heap comes to rest, its energy does not rise, and nothing sinks into anything."],
  ["Scene.RestCostsNothing", "What rests costs nothing, until something touches it."],
  ["SceneCluster.OneOnThreeOthers", "A stone that lies on three others is carried by forces that hold it, friction included."],
  ["SceneCluster.ConvergesWithTheStep", "Where stones touch several things, the error goes to nothing with the step."],
  ["CScene.HowTimeIsCutDoesNotMatter", "The same holds behind the interface that this page uses."],
];

export function sceneEvidence(host: HTMLElement): void {
  fold(host, "Why it is right", (body) => {
    body.append(el("p", "", {},
      "A stone by itself goes as in section 7: flights in closed form, impacts at moments that are solved for. Two stones meet at such a moment, too. " +
      "Stones that stay together, or lean on each other, are a cluster: it goes by steps of 2 ms, shorter where they turn fast, and in each all forces of its contacts are found together, each in its cone of friction. " +
      "That is of first order in the step, so whole scenes are less exact than one drop. Rest is a statement of statics: forces that hold every stone where it is."),
      el("ul", "evidence", {}, ...statements.map(([test, sentence]) => el("li", "", {}, sentence, " ", el("span", "witness", { "data-test": test }, `The test ${test}.`)))));
  });
}
