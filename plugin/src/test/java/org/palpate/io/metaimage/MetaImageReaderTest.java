package org.palpate.io.metaimage;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeHeader;

class MetaImageReaderTest {
  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({"mm, false", "um, true", "cm, true"})
  void aUnitOfLengthThatIsNotUsedIsNoted(String unit, boolean noted) throws Exception {
    VolumeHeader header = header("DistanceUnits = " + unit);
    assertEquals(0.5, header.grid().spacingMm().x);
    String note =
        "lengths are taken as mm, as in ITK: the DistanceUnits '" + unit + "' are not used";
    assertEquals(noted ? List.of(note) : List.of(), header.notes());
  }

  private VolumeHeader header(String field) throws Exception {
    String text =
        String.join(
            "\n",
            "ObjectType = Image",
            "NDims = 3",
            "BinaryData = True",
            "BinaryDataByteOrderMSB = False",
            "ElementSpacing = 0.5 0.75 2",
            "DimSize = 2 2 2",
            field,
            "ElementType = MET_UCHAR",
            "ElementDataFile = LOCAL",
            "12345678");
    Path file = folder.resolve("volume.mha");
    Files.write(file, text.getBytes(StandardCharsets.ISO_8859_1));
    return MetaImageReader.open(file, ReadOptions.defaults()).header();
  }
}
