MathJax.Hub.Config({ messageStyle: "none" });
// Formulas as MathML beside their pictures, for screen readers. It can be loaded only where there are formulas.
MathJax.Hub.Register.StartupHook("mml Jax Ready", function () {
  MathJax.Ajax.Require("[MathJax]/extensions/AssistiveMML.js");
});
