package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.testing.Scans;

/**
 * Compares what the commands write with recorded checksums, see {@link RecordedBehaviour}.
 *
 * <p>A change that is meant to alter results records them anew, in the same commit, with {@code
 * -Dpalpate.recordBehaviour=FOLDER}: the tests then write the files instead of comparing them.
 */
class RecordedBehaviourTest {
  @TempDir private Path folder;

  @Test
  void phantomsGiveTheRecordedBytes() throws IOException {
    compare("phantoms.sha256", RecordedBehaviour.ofPhantoms(folder));
  }

  @Test
  void scansGiveTheRecordedBytes() throws IOException {
    Path head = Scans.file("CThead/CThead_u16gz.nrrd");
    Path data = head.getParent().getParent();
    compare("scans.sha256", RecordedBehaviour.ofScans(folder, data));
  }

  private static void compare(String name, Map<String, String> checksums) throws IOException {
    String record = System.getProperty("palpate.recordBehaviour", "");
    if (!record.isEmpty()) {
      Files.writeString(Path.of(record, name), RecordedBehaviour.text(checksums));
      return;
    }
    assertEquals(recorded(name), RecordedBehaviour.text(checksums));
  }

  private static String recorded(String name) throws IOException {
    try (InputStream in = RecordedBehaviourTest.class.getResourceAsStream("behaviour/" + name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
