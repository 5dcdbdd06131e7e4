package org.palpate.io.raw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.RawLayout;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.testing.Scans;

class RawReaderTest {
  @TempDir Path folder;

  @Test
  void readsAFolderOfSlicesInTheOrderOfTheirNumbers() throws Exception {
    // data/README.md: >=1150 gives 34,295
    ReadOptions options =
        ReadOptions.defaults().withRaw(RawLayout.parse("64x64x93:u16le:3.2,3.2,1.5"));
    VolumeReader reader = VolumeFiles.open(Scans.file("small/headsq"), options);
    assertEquals(
        34_295,
        SegmentBuilder.read(reader, List.of(SegmentSpec.atLeast("bone", 1150)))
            .segments()
            .get(0)
            .bits()
            .solidCount());
    assertTrue(reader.files().get(9).endsWith("quarter.10"));
  }

  @Test
  void aLengthOtherThanTheLayoutIsRefused() throws Exception {
    Path file = Files.write(folder.resolve("a.raw"), new byte[23]);
    ReadOptions options = ReadOptions.defaults().withRaw(RawLayout.parse("2x3x2:u16be:1,1,1"));
    VolumeFormatException refused =
        assertThrows(VolumeFormatException.class, () -> VolumeFiles.open(file, options));
    assertTrue(refused.getMessage().contains("23 bytes but --raw describes 24"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "2x3:u8:1,1,1",
        "2x3x0:u8:1,1,1",
        "2x3x4:u16:1,1,1",
        "2x3x4:u8:1,1",
        "2x3x4:u8:1,-1,1",
        "2x3x4:u8:NaN,1,1",
        "2x3x4:u9:1,1,1",
        "3000000000x3x4:u8:1,1,1",
        "2x3x4:u8:1,1,1:5",
      })
  void aLayoutThatIsNotUnderstoodIsRefused(String layout) {
    assertThrows(VolumeFormatException.class, () -> RawLayout.parse(layout));
  }
}
