package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** A plot whose axes from 0 to 10 are 100 pixels long, from (62, 110) at the lower left. */
class SvgPlotTest {
  private final SvgPlot plot =
      new SvgPlot(
          176, 150, PlotAxis.fromZero("time [s]", 10), PlotAxis.fromZero("force [N] & more", 10));

  @Test
  void aLineGoesThroughItsPointsAndIsInterruptedWhereOneIsMissing() {
    plot.line("force", new double[] {0, 1, 2, 3, 10}, new double[] {0, 1, Double.NaN, 5, 10});
    assertDraws("<path class=\"force\" d=\"M62.0 110.0L72.0 100.0M92.0 60.0L162.0 10.0\"/>");
  }

  @Test
  void aMissingAbscissaInterruptsALineToo() {
    plot.line("a", new double[] {0, Double.POSITIVE_INFINITY, 2}, new double[] {0, 1, 2});
    assertDraws("<path class=\"a\" d=\"M62.0 110.0M82.0 90.0\"/>");
  }

  @Test
  void aRectangleReachesFromItsLowerLeftToItsUpperRightCorner() {
    plot.rectangle("hold", 1, 2, 4, 9, "<jaw> & 'skull'");
    assertDraws(
        "<rect class=\"hold\" x=\"72.0\" y=\"20.0\" width=\"30.0\" height=\"70.0\">"
            + "<title>&lt;jaw&gt; &amp; &#39;skull&#39;</title></rect>");
  }

  @Test
  void anEmptyRectangleIsStillVisible() {
    plot.rectangle("hold", 3, 3, 3, 3, "");
    assertDraws("x=\"92.0\" y=\"80.0\" width=\"1.0\" height=\"1.0\"");
  }

  @Test
  void aTextStandsBesideItsPoint() {
    plot.text(1, 1, "a < b");
    assertDraws("<text class=\"name\" x=\"76.0\" y=\"104.0\">a &lt; b</text>");
  }

  @Test
  void thePictureHasItsSizeTitleAndLabels() {
    assertDraws(
        "<svg role=\"img\" width=\"176\" height=\"150\" viewBox=\"0 0 176 150\">"
            + "<title>a &quot;title&quot;</title>");
    assertDraws("<text text-anchor=\"middle\" x=\"112.0\" y=\"142.0\">time [s]</text>");
    assertDraws("translate(14 60.0) rotate(-90)\">force [N] &amp; more</text>");
    assertTrue(svg().endsWith("</svg>\n"));
  }

  @Test
  void everyTickHasALineAcrossThePlotAndANumber() {
    assertDraws("<line class=\"grid\" x1=\"82.0\" y1=\"110.0\" x2=\"82.0\" y2=\"10.0\"/>");
    assertDraws("<text text-anchor=\"middle\" x=\"82.0\" y=\"124.0\">2</text>");
    assertDraws("<line class=\"grid\" x1=\"62.0\" y1=\"70.0\" x2=\"162.0\" y2=\"70.0\"/>");
    assertDraws("<text text-anchor=\"end\" x=\"56.0\" y=\"74.0\">4</text>");
    assertEquals(2 * 6, svg().split("class=\"grid\"", -1).length - 1, "0 to 10 by 2");
  }

  private void assertDraws(String mark) {
    assertTrue(svg().contains(mark), () -> mark + " is not in\n" + svg());
  }

  private String svg() {
    return plot.svg("a \"title\"");
  }
}
