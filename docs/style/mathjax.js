// Wide displayed formulas are broken into lines, above all on a phone. Formulas appear in chunks. MathJax would wait for
// 100 ms after each of them: a second for a chapter on a phone.
MathJax.Hub.Config({
  messageStyle: "none",
  SVG: { EqnChunkDelay: 0, linebreaks: { automatic: true, width: "94% container" } },
});
// Formulas inside of a line stay whole: in the narrow cell of a table they would be broken at every sign.
MathJax.Hub.Register.StartupHook("SVG Jax Ready", function () {
  const output = MathJax.OutputJax.SVG.constructor.prototype;
  const translate = output.Translate;
  output.Translate = function (script, state) {
    const formula = script.MathJax.elementJax.SVG;
    if (!formula.display) formula.lineWidth = Infinity;
    return translate.call(this, script, state);
  };
});
// Formulas as MathML beside their pictures, for screen readers. It can be loaded only where there are formulas.
MathJax.Hub.Register.StartupHook("mml Jax Ready", function () {
  MathJax.Ajax.Require("[MathJax]/extensions/AssistiveMML.js");
});
