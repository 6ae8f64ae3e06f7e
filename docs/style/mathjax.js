// Formulas appear in chunks, after each of which MathJax would wait for 100 ms: a second for a chapter on a phone.
MathJax.Hub.Config({ messageStyle: "none", SVG: { EqnChunkDelay: 0 } });
// Formulas as MathML beside their pictures, for screen readers. It can be loaded only where there are formulas.
MathJax.Hub.Register.StartupHook("mml Jax Ready", function () {
  MathJax.Ajax.Require("[MathJax]/extensions/AssistiveMML.js");
});
