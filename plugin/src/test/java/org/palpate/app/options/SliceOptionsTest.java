package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.host.LiveThreshold;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.MovableSlices.Mode;

class SliceOptionsTest {
  private static SliceOptions options(String... arguments) {
    return Given.options(new SliceOptions(), arguments);
  }

  private static VolumeSource grey(String... segments) throws IOException {
    String[] arguments = new String[segments.length + 1];
    arguments[0] = "--phantom=sphere:16:grey";
    System.arraycopy(segments, 0, arguments, 1, segments.length);
    return Given.source(arguments);
  }

  @Test
  void withoutTheOptionNoGreyValueIsRead() throws IOException {
    VolumeSource source = grey("--segment=s=>=500");
    assertFalse(options().isRequested());
    assertTrue(options().start(source).isEmpty());
    assertFalse(source.hasGreyValues());
  }

  @ParameterizedTest
  @CsvSource({
    "'0,0,0', FIXED, 0, 0, 0",
    "'15,-1,7', FIXED, 15, -1, 7",
    "middle, FIXED, 8, 8, 8",
    "point, AT_POINT, 8, 8, 8"
  })
  void planesStandWhereTheTextSays(String text, Mode mode, int i, int j, int k) throws IOException {
    SliceOptions options = options("--slices=" + text);
    MovableSlices.Start start = options.start(grey("--segment=s=>=500")).orElseThrow();
    assertEquals(mode, start.mode());
    assertEquals(i, start.i());
    assertEquals(j, start.j());
    assertEquals(k, start.k());
    assertEquals(text.equals("point"), options.followsProxy());
  }

  @ParameterizedTest
  @ValueSource(strings = {"1,2", "1,2,3,4", "1,2,x", "-2,0,0", "", "1.5,0,0", "top"})
  void anotherTextIsRefusedWithTheForms(String text) {
    Given.refuses(
        "the slices cannot be shown: --slices "
            + text
            + ": write three voxel numbers, such as --slices 64,64,32, or middle, or point",
        () -> options("--slices=" + text).start(grey("--segment=s=>=500")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"16,0,0", "0,16,0", "0,0,999999999"})
  void aPlaneBeyondTheVolumeIsRefusedWithItsSize(String text) {
    Given.refuses(
        "the slices cannot be shown: --slices " + text + ": the volume has 16 x 16 x 16 voxels",
        () -> options("--slices=" + text).start(grey("--segment=s=>=500")));
  }

  @Test
  void keysChangeTheFirstThresholdOnceItsValuesAreRead() throws IOException {
    VolumeSource source = grey("--segment=a=nonzero", "--segment=b=300..700", "--segment=c=>=1");
    assertTrue(SliceOptions.threshold(source).isEmpty(), "nothing is read yet");
    source.greyValues();
    LiveThreshold.Start start = SliceOptions.threshold(source).orElseThrow();
    assertEquals(1, start.segment());
    assertEquals(300, start.low());
    assertEquals(700, start.high());
    assertTrue(start.contrast() > 0);
    VolumeSource none = grey("--segment=a=nonzero");
    none.greyValues();
    assertTrue(SliceOptions.threshold(none).isEmpty());
  }
}
