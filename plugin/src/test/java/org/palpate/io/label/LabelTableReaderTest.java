package org.palpate.io.label;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.ReadOptions;
import org.palpate.testing.Scans;

class LabelTableReaderTest {
  @TempDir Path folder;

  @Test
  void namesTheAtlasByTheTableBesideItAndNotTheSkull() throws Exception {
    Optional<LabelTable> atlas =
        VolumeFiles.open(Scans.file("labels/HN-Atlas-labels.nrrd"), ReadOptions.defaults())
            .header()
            .labels();
    // HN-colors.ctbl: 25 mandible 220 225 105 255
    assertEquals(new Label("mandible", 0xDCE169), atlas.get().labels().get(25L));
    assertTrue(
        VolumeFiles.open(Scans.file("labels/Skull.nrrd"), ReadOptions.defaults())
            .header()
            .labels()
            .isEmpty());
  }

  @Test
  void tablesOfItkSnapAndFreeSurferAreUnderstood() throws Exception {
    Files.writeString(
        folder.resolve("snap.label"),
        """
        # ITK-SnAP
            0     0    0    0        0  0  0    "Clear"
            7   255    0   16        1  1  1    "Lower jaw"
        """);
    Files.writeString(
        folder.resolve("free.txt"),
        """
        #No. Label Name:   R   G   B   A

        2   Left-Cerebral-White-Matter   245 244 243 0
        """);
    assertEquals(
        new Label("Lower jaw", 0xFF0010),
        LabelTableReader.beside(folder.resolve("snap.nii.gz")).get().labels().get(7L));
    assertEquals(
        new Label("Left-Cerebral-White-Matter", 0xF5F4F3),
        LabelTableReader.beside(folder.resolve("free.nii")).get().labels().get(2L));
  }

  @Test
  void ignoresTablesThatAreAmbiguous() throws Exception {
    Files.writeString(folder.resolve("head-a.ctbl"), "1 one 1 2 3 255\n");
    Files.writeString(folder.resolve("head-b.ctbl"), "1 other 1 2 3 255\n");
    assertTrue(LabelTableReader.beside(folder.resolve("head-labels.nrrd")).isEmpty());
  }
}
