package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.testing.Scans;

/** Tests every option that controls how a volume is read, and the files that are exported. */
class ReadingOptionsTest {
  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({"0, 5538.065757632256", "1, 5466.730765342712"})
  void timeChoosesAStep(int step, String highest) throws IOException {
    // nibabel: numpy.asanyarray(image.dataobj)[..., step].max()
    Path volume = Scans.file("formats/nifti/functional.nii");
    Path report = folder.resolve("r.json");
    CommandRun run =
        CommandRun.of("info", "--volume", volume, "--time", step, "--report", report).mustSucceed();
    assertTrue(run.out().contains("step " + step + " of 20"), run.out());
    assertEquals(highest, FlatJson.read(report).get("/value_range/1"));
  }

  @Test
  void aFileOfSeveralStepsNeedsAChoiceAndAFileOfOneStepRefusesOthers() throws IOException {
    Path many = Scans.file("formats/nifti/functional.nii");
    assertTrue(
        CommandRun.of("info", "--volume", many)
            .mustRefuse()
            .contains("choose one with --time 0 to --time 19"));
    Path one = TestFiles.nrrd(folder.resolve("v.nrrd"), 8, v -> v[0] & 1);
    CommandRun.of("info", "--volume", one, "--time", 0).mustSucceed();
    assertTrue(
        CommandRun.of("info", "--volume", one, "--time", 3).mustRefuse().contains("no step 3"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"--time=1", "--series=1", "--resample", "--raw=4x4x4:u8:1,1,1"})
  void aReadingOptionWithoutAFileIsRefused(String option) {
    assertTrue(CommandRun.of("info", option).mustRefuse().contains("without a file"));
  }

  @Test
  void seriesChoosesOneSeriesOfAFolder() throws IOException {
    Path files = Scans.file("formats/dicom");
    for (String name : new String[] {"CT_small.dcm", "MR_small.dcm"}) {
      Files.copy(files.resolve(name), folder.resolve(name));
    }
    assertTrue(
        CommandRun.of("info", "--volume", folder)
            .mustRefuse()
            .contains("the folder has 2 series: 1 CT, 1 file of 128x128; 2 MR, 1 file of 64x64"));
    String second = CommandRun.of("info", "--volume", folder, "--series", 2).mustSucceed().out();
    assertTrue(second.contains("64 x 64 x 1 voxels"), second);
    assertTrue(
        CommandRun.of("info", "--volume", folder, "--series", 3)
            .mustRefuse()
            .contains("--series 1 to --series 2"));
    assertTrue(
        CommandRun.of("info", "--volume", folder.resolve("CT_small.dcm"), "--series", 1)
            .mustRefuse()
            .contains("leave --series out"));
  }

  @Test
  void resampleInterpolatesTheMissingSliceAndReportsIt() throws IOException {
    Path all = Scans.file("LIDC/dicom_10slices");
    try (Stream<Path> files = Files.list(all).sorted()) {
      for (Path file : files.toList()) {
        Files.copy(file, folder.resolve(file.getFileName()));
      }
    }
    CommandRun.of("info", "--volume", folder).mustSucceed();
    try (Stream<Path> files = Files.list(folder).sorted()) {
      Files.delete(files.skip(4).findFirst().orElseThrow());
    }
    String refusal = CommandRun.of("info", "--volume", folder).mustRefuse();
    assertTrue(refusal.contains("--resample"), refusal);
    String made = CommandRun.of("info", "--volume", folder, "--resample").mustSucceed().out();
    assertTrue(made.contains("512 x 512 x 10 voxels"), made);
    assertTrue(made.contains("note"), made);
  }

  @Test
  void rawDescribesAFolderOfSlices() throws IOException {
    // data/README.md
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "info",
            "--volume",
            Scans.file("small/headsq"),
            "--raw",
            "64x64x93:u16le:3.2,3.2,1.5",
            "--segment",
            "head=>=1150",
            "--report",
            report)
        .mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("34295", json.get("/segments/0/voxels"));
    assertEquals("3.2", json.get("/spacing_mm/0"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"bone.nrrd", "bone.nii", "bone.nii.gz"})
  void anExportedSegmentReadsBackToTheVoxel(String name) throws IOException {
    Path written = folder.resolve(name);
    CommandRun.of(
            "info",
            "--volume",
            Scans.file("totalseg/example_ct.nii.gz"),
            "--segment",
            "bone=>=200",
            "--export",
            written,
            "--report",
            folder.resolve("a.json"))
        .mustSucceed();
    CommandRun.of("info", "--volume", written, "--report", folder.resolve("b.json")).mustSucceed();
    Map<String, String> was = FlatJson.read(folder.resolve("a.json"));
    Map<String, String> is = FlatJson.read(folder.resolve("b.json"));
    assertTrue(Integer.parseInt(was.get("/segments/0/voxels")) > 1000, was.toString());
    for (String key : was.keySet()) {
      if (key.startsWith("/segments/0/box") || key.equals("/segments/0/voxels")) {
        assertEquals(was.get(key), is.get(key), key);
      }
    }
  }

  @Test
  void exportNeverOverwritesItsInput() throws IOException {
    Path volume = TestFiles.nrrd(folder.resolve("v.nrrd"), 8, v -> v[0] & 1);
    byte[] before = Files.readAllBytes(volume);
    CommandRun.of("info", "--volume", volume, "--export", volume).mustRefuse();
    CommandRun.of("info", "--volume", volume, "--export", folder.resolve("v.bmp")).mustRefuse();
    assertArrayEquals(before, Files.readAllBytes(volume));
    assertFalse(Files.exists(folder.resolve("v.bmp")));
  }

  @Test
  void labelsAreNamedByTheTableBesideTheFile() throws IOException {
    Path volume = TestFiles.nrrd(folder.resolve("jaws.nrrd"), 8, v -> v[2] < 4 ? 7 : 9);
    Files.writeString(
        folder.resolve("jaws.ctbl"), "7 lower_jaw 1 2 3 255\n9 upper_jaw 4 5 6 255\n");
    String out = CommandRun.of("info", "--volume", volume).mustSucceed().out();
    assertTrue(out.contains("lower jaw: 256 voxels"), out);
    assertTrue(out.contains("upper jaw: 256 voxels"), out);
  }

  @Test
  void reportsTheOrientationOfTheSlicesInThePatient() {
    String out =
        CommandRun.of("info", "--volume", Scans.file("labels/HN-Atlas-labels.nrrd"))
            .mustSucceed()
            .out();
    assertTrue(out.contains("axial slices, 1.4 mm apart, running to the patient's head"), out);
    assertTrue(out.contains("in a slice x runs to the patient's right, y to the front"), out);
    assertTrue(out.contains("spacing   0.97656 x 0.97656 x 1.4 mm"), out);
  }
}
