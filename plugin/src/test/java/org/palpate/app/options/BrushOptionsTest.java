package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.app.options.BrushOptions.Brush;
import org.palpate.app.options.BrushOptions.Paint;
import org.palpate.edit.BrushLimits;
import org.palpate.host.ContactScene;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;

class BrushOptionsTest {
  private static final String[] GREY = {
    "--phantom=sphere:16:grey", "--segment=low=>=200", "--segment=high=>=800"
  };

  private static BrushOptions options(String... arguments) {
    return Given.options(new BrushOptions(), arguments);
  }

  private static Brush brush(BrushOptions options, Optional<RigidTool> tool, String... contact)
      throws IOException {
    VolumeSource source = Given.source(GREY);
    ContactScene scene =
        new ContactScene(
            Given.segments(source), Given.options(new ContactOptions(), contact).settings());
    return options.brush(source, scene, tool).orElseThrow();
  }

  @Test
  void withoutTheOptionThereIsNoBrush() throws IOException {
    BrushOptions none = options();
    none.check(false, true);
    assertFalse(none.isGiven());
    VolumeSource source = Given.source("--phantom=sphere:16");
    ContactScene scene =
        new ContactScene(Given.segments(source), Given.options(new ContactOptions()).settings());
    assertEquals(Optional.empty(), none.brush(source, scene, Optional.empty()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "-1", "1000.5", "NaN", "", "wide"})
  void theRadiusLiesAboveZeroAndUpToAMetre(String radius) {
    String brush = radius + ",refuse";
    Given.refuses(
        "the brush cannot be read: --brush "
            + brush
            + ": begin with a radius above 0 and up to 1,000 mm, or with tool, as in --brush"
            + " 3,refuse",
        () -> options("--brush=" + brush).check(true, false));
    options("--brush=1000").check(false, false);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "3,hard|write segment:NAME, range:LOW..HIGH or refuse after the commas",
        "3,|write segment:NAME, range:LOW..HIGH or refuse after the commas",
        "3,range:9..1|write a range as LOW..HIGH or >=LOW",
        "3,range:|write a range as LOW..HIGH or >=LOW"
      })
  void whatFollowsTheRadiusIsRefusedIfUnknown(String brush, String remedy) {
    Given.refuses(
        "the brush cannot be read: --brush " + brush + ": " + remedy,
        () -> options("--brush=" + brush).check(false, false));
  }

  @Test
  void paintingNeedsABrushAndABrushAShape() {
    Given.refuses(
        "painting needs a brush: --paint: add for example --brush 3",
        () -> options("--paint=add").check(false, false));
    Given.refuses(
        "a point has no shape: --brush tool: give a radius in mm, or choose a --tool",
        () -> options("--brush=tool").check(false, false));
    options("--brush=tool").check(true, false);
    Given.refuses(
        "a brush is for the segments of one volume: --brush: leave out --scene",
        () -> options("--brush=3").check(false, true));
  }

  @Test
  void aBallChangesTheFirstSegmentWithoutLimits() throws IOException {
    Brush brush = brush(options("--brush=2.5"), Optional.empty());
    assertEquals(new Brush(OptionalDouble.of(2.5), 0, BrushLimits.NONE, Optional.empty()), brush);
  }

  @Test
  void eachPartOfTheTextArrives() throws IOException {
    BrushOptions options = options("--brush=2,segment:high,range:100..600,refuse", "--paint=erase");
    Brush brush = brush(options, Optional.empty(), "--protect=low:1:0");
    assertTrue(options.isGiven());
    assertEquals(1, brush.segment());
    assertEquals(Optional.of(Paint.ERASE), brush.start());
    assertTrue(brush.limits().sparesTool());
    assertTrue(brush.limits().kept().orElseThrow().solidCount() > 0);
    BitCube only = brush.limits().only().orElseThrow();
    VolumeSource source = Given.source(GREY);
    for (int i = 0; i < 16; i++) {
      double value = source.greyValues().value(i, 8, 8);
      assertEquals(value >= 100 && value <= 600, only.get(i, 8, 8), "value=" + value);
    }
  }

  @Test
  void aSegmentThatIsNotThereIsRefused() {
    Given.refuses(
        "the brush cannot be read: --brush 2,segment:bone: there is no such segment; list them with"
            + " palpate info",
        () -> brush(options("--brush=2,segment:bone"), Optional.empty()));
  }

  @Test
  void aToolIsABrushOnlyIfItIsSolidAndWhole() throws IOException {
    RigidTool whole = ToolSampler.ofShape(RodShape.sphere(2), 0.7);
    Brush brush = brush(options("--brush=tool", "--paint=add"), Optional.of(whole));
    assertEquals(OptionalDouble.empty(), brush.radiusMm());
    assertEquals(Optional.of(Paint.ADD), brush.start());
    Given.refuses(
        "an open or thinned tool has no shape: --brush tool: give a radius in mm",
        () -> brush(options("--brush=tool"), Optional.of(whole.thinned(5))));
  }
}
