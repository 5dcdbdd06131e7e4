package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.opencl.OpenClCatalog;

/** Runs commands with {@code --collision-device}, with and without OpenCL. */
class CollisionDeviceCommandTest {
  @TempDir private Path folder;

  private Path file(String name) {
    return folder.resolve(name);
  }

  @Test
  void aReplayOnOpenClWritesTheBytesOfOneOnTheCpu() throws IOException {
    StringBuilder text = new StringBuilder("t_ms,x,y,z\n");
    for (int frame = 0; frame < 200; frame++) {
      text.append(frame).append(",16,").append(16 + frame % 3 * 0.1).append(',');
      text.append(36 - 0.1 * frame).append('\n');
    }
    Files.writeString(file("t.csv"), text);
    replay("cpu");
    String said = replay("opencl");
    assertArrayEquals(bytes("cpu.frames.csv"), bytes("opencl.frames.csv"));
    assertArrayEquals(bytes("cpu.legs.csv"), bytes("opencl.legs.csv"));
    Map<String, String> report = FlatJson.read(file("opencl.json"));
    assertEquals(FlatJson.read(file("cpu.json")).get("/work/max"), report.get("/work/max"));
    assertEquals("", report.get("/collision_device/failure"));
    OpenClCatalog.Listing listing = OpenClCatalog.list();
    if (listing.why().isEmpty()) {
      assertEquals(listing.devices().get(0).name(), report.get("/collision_device/name"));
    } else {
      assertEquals("cpu", report.get("/collision_device/name"));
      assertTrue(said.contains("continuing with the CPU"), said);
    }
  }

  private String replay(String device) {
    return CommandRun.of(
            "replay",
            "--trajectory",
            file("t.csv"),
            "--phantom",
            "sphere:32",
            "--tool",
            "sphere:2",
            "--collision-device",
            device,
            "--out",
            file(device + ".frames.csv"),
            "--legs",
            file(device + ".legs.csv"),
            "--report",
            file(device + ".json"))
        .mustSucceed()
        .err();
  }

  private byte[] bytes(String name) throws IOException {
    return Files.readAllBytes(file(name));
  }

  @Test
  void devicesListsOpenClOrSaysWhyThereIsNone() throws IOException {
    CommandRun.of("devices", "--report", file("d.json")).mustSucceed();
    Map<String, String> report = FlatJson.read(file("d.json"));
    int last = 0;
    while (report.containsKey("/backends/" + (last + 1) + "/name")) {
      last++;
    }
    assertEquals("opencl", report.get("/backends/" + last + "/name"));
    String why = OpenClCatalog.list().why();
    assertEquals(why, report.get("/backends/" + last + "/why"));
    assertEquals(why.isEmpty() + "", report.get("/backends/" + last + "/usable"));
  }

  @Test
  void aNameThatNoDeviceHasIsRefused() {
    assumeTrue(OpenClCatalog.list().why().isEmpty(), "skipped, because it needs OpenCL");
    String said =
        CommandRun.of("touch", "--explain", "--collision-device", "opencl:no such card")
            .mustRefuse();
    assertTrue(said.contains("no OpenCL device has this name"), said);
  }
}
