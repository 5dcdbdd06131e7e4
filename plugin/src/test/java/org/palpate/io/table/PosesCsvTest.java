package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.body.BodyEvent;
import org.palpate.geometry.Pose;

class PosesCsvTest {
  private static final String HEADER = "frame,body,x,y,z,qw,qx,qy,qz";
  private static final List<String> BODIES = List.of("base", "part");

  @TempDir private Path folder;

  private List<BodyPose> read(String... lines) throws IOException {
    Path file = folder.resolve("p.csv");
    Files.writeString(file, String.join("\n", lines) + "\n");
    return PosesCsv.read(file, BODIES);
  }

  @Test
  void aRecordedTableKeepsEveryEventAndEveryBit() throws IOException {
    SplittableRandom random = new SplittableRandom(3);
    Path file = folder.resolve("p.csv");
    BodyEvent[] events = BodyEvent.values();
    Pose[] poses = new Pose[events.length];
    Pose[] inHand = new Pose[events.length];
    try (OutputStream stream = Files.newOutputStream(file)) {
      CsvWriter rows = PosesCsv.writer(stream);
      for (int n = 0; n < events.length; n++) {
        poses[n] = pose(random);
        inHand[n] = pose(random);
        PosesCsv.add(rows, 10L * n, "part", events[n], poses[n], inHand[n]);
      }
    }
    List<BodyPose> read = PosesCsv.read(file, BODIES);
    assertEquals(poses.length, read.size());
    for (int n = 0; n < events.length; n++) {
      BodyPose row = read.get(n);
      assertEquals(events[n], row.event());
      assertEquals(10L * n, row.frame());
      assertEquals(1, row.body());
      assertTrue(row.restToPresent().sameBits(poses[n]), row.event() + " " + row.restToPresent());
      assertEquals(
          row.event() == BodyEvent.TAKEN, row.inHand().sameBits(inHand[n]), "" + row.event());
    }
  }

  /** Returns a pose whose quaternion does not change when it is normalized. */
  private static Pose pose(SplittableRandom random) {
    Pose pose = new Pose();
    pose.translation.set(random.nextDouble(), -1e5 * random.nextDouble(), 0.1);
    do {
      pose.rotation.set(random.nextDouble(), -random.nextDouble(), random.nextDouble(), 0.5);
      pose.rotation.normalize();
    } while (changesWhenNormalized(pose));
    return pose;
  }

  private static boolean changesWhenNormalized(Pose pose) {
    Pose again = new Pose().set(pose);
    again.rotation.normalize();
    return !again.sameBits(pose);
  }

  @Test
  void aPlainTableMovesBodies() throws IOException {
    List<BodyPose> rows =
        read("qz,qy,qx,qw,z,y,x,body,frame", "0,0,0,1,3,2,1,part,4", "0,1,0,0,0,0,0,base,4");
    assertEquals(BodyEvent.MOVED, rows.get(0).event());
    assertEquals("(1.0, 2.0, 3.0)", rows.get(0).restToPresent().translation.toString());
    assertEquals(0, rows.get(1).body());
    assertEquals(1, rows.get(1).restToPresent().rotation.y);
  }

  @Test
  void anEventMayBeLeftOut() throws IOException {
    List<BodyPose> rows =
        read(
            HEADER + ",event",
            "0,part,1,2,3,1,0,0,0,",
            "0,part,1,2,3,1,0,0,0",
            "1,part,1,2,3,1,0,0,0,placed");
    assertEquals(BodyEvent.MOVED, rows.get(0).event());
    assertEquals(BodyEvent.MOVED, rows.get(1).event());
    assertEquals(BodyEvent.PLACED, rows.get(2).event());
  }

  @Test
  void aRoundedQuaternionIsNormalized() throws IOException {
    Pose pose = read(HEADER, "0,part,0,0,0,0.7071,0.7071,0,0").get(0).restToPresent();
    assertEquals(1, pose.rotation.norm(), 1e-15);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "4,part,0,0,0,1,0,0,0|frames run backward, from 5.0 to 4.0|sort the rows",
        "5.5,part,0,0,0,1,0,0,0|frame is 5.5|count frames from 0",
        "-1,part,0,0,0,1,0,0,0|frame is -1.0|count frames from 0",
        "2e15,part,0,0,0,1,0,0,0|frame is 2.0E15|count frames from 0",
        "6,head,0,0,0,1,0,0,0|there is no body head|name a segment of the volume",
        "6,part,0,0,NaN,1,0,0,0|z is NaN|correct the row",
        "6,part,0,inf,0,1,0,0,0|y is inf|correct the row",
        "6,part,0,0|z is missing|write numbers with a dot",
        "6,part,0,0,0,1,0,0,one|qz is no number: one|write numbers with a dot",
        "6,part,0,0,1048577,1,0,0,0|z is 1048577.0|no body moves farther than 1048576 mm along an"
            + " axis",
        "6,part,0,0,0,1.1,0,0,0|the quaternion qw,qx,qy,qz has the norm 1.1 instead of 1|normalize"
            + " it",
        "6,part,0,0,0,1,0,0,0,thrown|event is thrown|write moved, taken, joined, held, released or"
            + " placed, or nothing",
        "6,part,0,0,0,1,0,0,0,taken|hx is missing|write numbers with a dot"
      })
  void aRowThatDoesNotFitIsRefusedWithItsLine(String row, String what, String remedy) {
    CsvFormatException refusal =
        assertThrows(
            CsvFormatException.class,
            () -> read(HEADER + ",event", "5,base,0,0,0,1,0,0,0", "", row));
    assertEquals(
        what + ": " + folder.resolve("p.csv") + " line 4: " + remedy, refusal.getMessage());
  }
}
