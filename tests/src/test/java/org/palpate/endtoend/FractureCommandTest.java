package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FractureCommandTest {
  @TempDir private Path folder;

  @Test
  void aPhantomHasASegmentForEachFragment() throws IOException {
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--phantom", "fracture:64:5:7:0", "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("phantom fracture:64:5:7:0", json.get("/volume"));
    for (int n = 0; n < 5; n++) {
      assertEquals("fragment" + (n + 1), json.get("/segments/" + n + "/name"));
      assertTrue(Integer.parseInt(json.get("/segments/" + n + "/voxels")) > 64);
    }
    assertTrue(!json.containsKey("/segments/5/name"));
  }

  @Test
  void theOnlySegmentOfAVolumeIsCutIntoLabels() throws IOException {
    Path parts = folder.resolve("parts.nrrd");
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--phantom", "torus:64", "--fracture", "4:9:0", "--export", parts)
        .mustSucceed();
    CommandRun.of("info", "--volume", parts, "--report", report).mustSucceed();
    Map<String, String> cut = FlatJson.read(report);
    CommandRun.of("info", "--phantom", "torus:64", "--report", report).mustSucceed();
    long sum = 0;
    for (int n = 0; n < 4; n++) {
      assertEquals("fragment" + (n + 1), cut.get("/segments/" + n + "/name"));
      sum += Long.parseLong(cut.get("/segments/" + n + "/voxels"));
    }
    assertEquals(FlatJson.read(report).get("/segments/0/voxels"), Long.toString(sum));
  }

  @Test
  void theJawOfAScanIsCut() throws IOException {
    Path labels = TestFiles.scan("labels/HN-Atlas-labels.nrrd");
    Path parts = folder.resolve("parts.nii.gz");
    String out =
        CommandRun.of(
                "info",
                "--volume",
                labels,
                "--segment",
                "jaw=label:25",
                "--fracture",
                "8:2",
                "--export",
                parts)
            .mustSucceed()
            .out();
    assertTrue(out.contains("fragment8"), out);
  }

  @Test
  void wrongUseIsRefusedInOneLine() {
    Path parts = folder.resolve("parts.nrrd");
    CommandRun.of("info", "--phantom", "torus:64", "--fracture", "4").mustRefuse();
    for (String fracture : new String[] {"1", "9", "4:x", "4:1:5", "", "4:1:1:1"}) {
      CommandRun.of("info", "--phantom", "torus:64", "--fracture", fracture, "--export", parts)
          .mustRefuse();
    }
    CommandRun.of("info", "--phantom", "head:64", "--fracture", "4", "--export", parts)
        .mustRefuse();
    for (String phantom :
        new String[] {"fracture:10", "fracture:x", "fracture:64:9", "fractures"}) {
      CommandRun.of("info", "--phantom", phantom).mustRefuse();
    }
  }
}
