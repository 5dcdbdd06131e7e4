package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.app.process.PalpateException;
import org.palpate.force.EffectPlan;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

class EffectOptionsTest {
  private static final EffectSite SITE =
      new EffectSite(RigidTransform.identity(), 0.5, 0, 10, List.of(new Vec3()));

  private static EffectOptions options(String... effects) {
    List<String> arguments = new ArrayList<>();
    for (String effect : effects) {
      arguments.add("--effect=" + effect);
    }
    return Given.options(new EffectOptions(), arguments.toArray(new String[0]));
  }

  private static List<EffectPlan> plans(EffectOptions options, String... volume)
      throws IOException {
    VolumeSource source = Given.source(volume);
    return options.plans(source, Given.segments(source));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "viscosity:0.000001",
        "viscosity:0.1",
        "stickslip:0.001",
        "stickslip:1000",
        "vibration:1,0.001",
        "vibration:400,1000",
        "magnet:bone,0.001,1000",
        "magnet:bone,1000,0.001",
        "texture:0.001",
        "texture:10"
      })
  void theEndsOfEachRangeAreAllowed(String effect) {
    options(effect).check();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "viscosity:0.11|viscosity:NS/MM with 0.000001 to 0.1 N s/mm",
        "viscosity:9e-7|viscosity:NS/MM with 0.000001 to 0.1 N s/mm",
        "viscosity|viscosity:NS/MM with 0.000001 to 0.1 N s/mm",
        "viscosity:0.1,1|viscosity:NS/MM with 0.000001 to 0.1 N s/mm",
        "stickslip:0|stickslip:N with 0.001 to 1,000 N",
        "stickslip:1001|stickslip:N with 0.001 to 1,000 N",
        "stickslip:NaN|stickslip:N with 0.001 to 1,000 N",
        "vibration:0.9,1|vibration:HZ,N with 1 to 400 Hz and 0.001 to 1,000 N",
        "vibration:401,1|vibration:HZ,N with 1 to 400 Hz and 0.001 to 1,000 N",
        "vibration:50|vibration:HZ,N with 1 to 400 Hz and 0.001 to 1,000 N",
        "vibration:50,0|vibration:HZ,N with 1 to 400 Hz and 0.001 to 1,000 N",
        "magnet:1,2|magnet:NAME,N,MM with 0.001 to 1,000 N and 0.001 to 1,000 mm",
        "magnet:a,b,1,2|magnet:NAME,N,MM with 0.001 to 1,000 N and 0.001 to 1,000 mm",
        "magnet:a,1,1001|magnet:NAME,N,MM with 0.001 to 1,000 N and 0.001 to 1,000 mm",
        "texture:10.5|texture:MM with 0.001 to 10 mm",
        "texture:|texture:MM with 0.001 to 10 mm"
      })
  void anEffectOutOfRangeIsRefusedWithItsForm(String effect, String form) {
    Given.refuses(
        "the effect cannot be read: --effect " + effect + ": write " + form,
        () -> options("viscosity:0.01", effect).check());
  }

  @Test
  void anUnknownEffectIsRefusedWithTheKindsThatThereAre() {
    Given.refuses(
        "there is no such effect: --effect glue:1: choose viscosity, magnet, stickslip, vibration"
            + " or texture with its values",
        () -> options("glue:1").check());
  }

  @Test
  void aColonDividesKindAndValues() {
    assertEquals("path", EffectOptions.kind("path:C:\\a.csv"));
    assertEquals("C:\\a.csv", EffectOptions.values("path:C:\\a.csv"));
    assertEquals("plane", EffectOptions.kind("plane"));
    assertEquals("", EffectOptions.values("plane"));
    assertEquals("", EffectOptions.values("plane:"));
  }

  @Test
  void onlyATextureNeedsGreyValues() {
    assertTrue(options("viscosity:0.01", "texture:0.2").needsGrey());
    assertFalse(options("viscosity:0.01", "magnet:texture,1,2").needsGrey());
    assertFalse(options().needsGrey());
  }

  @Test
  void effectsKeepTheirOrderAndTheirValues() throws IOException {
    List<EffectPlan> plans =
        plans(options("viscosity:0.02", "magnet:sphere,2,4"), "--phantom=sphere:16");
    HandState hand = new HandState();
    hand.velocityMmPerSecond.set(10, 0, -5);
    assertEquals("(-0.2, 0.0, 0.1)", forceOf(plans.get(0), hand).toString());
    hand.velocityMmPerSecond.set(0, 0, 0);
    hand.device.translation.set(8, 8, 16);
    hand.tool.translation.set(8, 8, 16);
    Vec3 pull = forceOf(plans.get(1), hand);
    assertTrue(pull.z < 0 && pull.length() <= 2, "drawn towards the ball: " + pull);
    hand.device.translation.set(8, 8, 24);
    hand.tool.translation.set(8, 8, 24);
    assertEquals(0, forceOf(plans.get(1), hand).length(), "out of reach");
  }

  private static Vec3 forceOf(EffectPlan plan, HandState hand) {
    HapticEffect effect = plan.make(SITE);
    effect.reset();
    Vec3 force = new Vec3();
    effect.add(hand, force, new Vec3());
    return force;
  }

  @Test
  void aMagnetNeedsASegmentThatIsThereAndNotTooLarge() {
    Given.refuses(
        "there is no such segment: --effect magnet:bone,1,3: choose sphere",
        () -> plans(options("magnet:bone,1,3"), "--phantom=sphere:16"));
    PalpateException large =
        assertThrows(
            PalpateException.class,
            () -> plans(options("magnet:sphere,1,900"), "--phantom=sphere:16"));
    assertTrue(
        large.getMessage().startsWith("the segment and its margin fill a box of ")
            && large
                .getMessage()
                .endsWith(
                    " voxels, more than 33,554,432: --effect magnet:sphere,1,900: choose a smaller"
                        + " margin or a smaller segment"),
        large.getMessage());
  }

  @Test
  void aTextureNeedsAThreshold() throws IOException {
    Given.refuses(
        "a texture needs grey values: --effect texture:0.2: choose segments by a threshold, as in"
            + " --segment 'bone=>=1500'",
        () -> plans(options("texture:0.2"), "--phantom=sphere:16"));
    List<EffectPlan> plans =
        plans(options("texture:0.2"), "--phantom=sphere:16:grey", "--segment=s=>=500");
    assertEquals(1, plans.size());
  }
}
