package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.raycast.Ray;
import org.palpate.testing.FilteredOracle;
import org.palpate.volume.SegmentedVolume;

/** Replays with bodies that move: {@code palpate replay --poses}. */
class MovingReplayTest {
  @TempDir private Path folder;

  private Path scan;

  private Path file(String name) {
    return folder.resolve(name);
  }

  /** Two blobs; the device circles about the second, which moves to and fro and turns. */
  @BeforeEach
  void writeScene() throws IOException {
    scan =
        TestFiles.nrrd(
            file("scan.nrrd"), 30, v -> blob(v, 7, 15, 15, 5) ? 1 : blob(v, 21, 15, 15, 5) ? 2 : 0);
    Vec3 middle =
        VolumeFiles.open(scan, ReadOptions.defaults())
            .header()
            .grid()
            .gridToWorld(new Vec3(21, 15, 15), new Vec3());
    StringBuilder device = new StringBuilder("t_ms,x,y,z\n");
    StringBuilder poses = new StringBuilder("frame,body,x,y,z,qw,qx,qy,qz\n");
    for (int n = 0; n < 600; n++) {
      device.append(n).append(',').append(middle.x + 9 * Math.cos(0.02 * n)).append(',');
      device.append(middle.y + 9 * Math.sin(0.02 * n)).append(',').append(middle.z).append('\n');
      if (n % 30 == 0) {
        poses.append(n).append(",mover,").append(n / 30 % 2 == 0 ? -12 : 6).append(",1,0.5,");
        poses.append("0.9999500004,0.01,0,0\n");
      }
    }
    Files.writeString(file("t.csv"), device);
    Files.writeString(file("p.csv"), poses);
  }

  private static boolean blob(int[] v, double x, double y, double z, double radius) {
    double dx = v[0] + 0.5 - x;
    double dy = v[1] + 0.5 - y;
    double dz = v[2] + 0.5 - z;
    return dx * dx + dy * dy + dz * dz < radius * radius;
  }

  private CommandRun replay(String tool, String suffix, Object... further) {
    List<Object> args = new ArrayList<>(arguments(tool, suffix));
    args.addAll(List.of(further));
    return CommandRun.of(args.toArray());
  }

  private List<Object> arguments(String tool, String suffix) {
    return List.of(
        "replay",
        "--volume",
        scan,
        "--segment",
        "still=label:1",
        "--segment",
        "mover=label:2",
        "--tool",
        tool,
        "--trajectory",
        file("t.csv"),
        "--poses",
        file("p.csv"),
        "--out",
        file("f" + suffix),
        "--legs",
        file("l" + suffix),
        "--report",
        file("r" + suffix));
  }

  @Test
  void everyLegOfAToolAmongBodiesThatMoveIsFreeAndChainsBitForBit() throws IOException {
    SegmentedVolume volume =
        SegmentBuilder.read(
            VolumeFiles.open(scan, ReadOptions.defaults()),
            List.of(SegmentSpec.parse("still=label:1"), SegmentSpec.parse("mover=label:2")));
    for (String tool : new String[] {"point", "sphere:2"}) {
      replay(tool, tool).mustSucceed();
      assertEquals(0, touching(volume, file("l" + tool)));
      Map<String, String> report = FlatJson.read(file("r" + tool));
      assertEquals("1", report.get("/moving/bodies"));
      assertTrue(Integer.parseInt(report.get("/moving/motions")) > 50, report.toString());
      assertTrue(Integer.parseInt(report.get("/moving/pushes")) > 0, report.toString());
      assertTrue(Integer.parseInt(report.get("/moving/held_back")) > 0, report.toString());
    }
  }

  /** Returns the number of legs that touch a voxel; fails if a leg does not begin at its end. */
  private static int touching(SegmentedVolume volume, Path legs) throws IOException {
    FilteredOracle oracle = new FilteredOracle();
    Ray ray = new Ray();
    Map<String, String> ends = new HashMap<>();
    int touching = 0;
    List<String> rows = Files.readAllLines(legs);
    assertTrue(rows.size() > 1_000, rows.size() + " rows");
    for (String row : rows.subList(1, rows.size())) {
      String[] words = row.split(",", -1);
      String chain = words[2] + "," + words[3];
      String start = words[4] + "," + words[5] + "," + words[6];
      String end = words[7] + "," + words[8] + "," + words[9];
      if (!words[1].equals("-1")) {
        assertEquals(ends.getOrDefault(chain, start), start, row);
      }
      ends.put(chain, end);
      double[] n = ToolLegsFile.numbers(row);
      ray.from(n[4], n[5], n[6]).to(n[7], n[8], n[9]);
      touching += oracle.touchesAny(volume.segments().get((int) n[2]).bits(), ray) ? 1 : 0;
    }
    return touching;
  }

  @Test
  void theSamePosesGiveTheSameBytesAndPosesAreApplied() throws IOException {
    replay("sphere:2", "a").mustSucceed();
    replay("sphere:2", "b").mustSucceed();
    assertArrayEquals(Files.readAllBytes(file("fa")), Files.readAllBytes(file("fb")));
    assertArrayEquals(Files.readAllBytes(file("la")), Files.readAllBytes(file("lb")));
    Files.writeString(file("p.csv"), "frame,body,x,y,z,qw,qx,qy,qz\n0,mover,0,0,0,1,0,0,0\n");
    replay("sphere:2", "c").mustSucceed();
    assertFalse(Files.readString(file("fa")).equals(Files.readString(file("fc"))));
  }

  @Test
  void wrongPosesAreOneLineAndExitCodeTwo() throws IOException {
    String header = "frame,body,x,y,z,qw,qx,qy,qz\n";
    Map<String, String> wrong = new HashMap<>();
    wrong.put(header + "0,nobody,0,0,0,1,0,0,0\n", "there is no body nobody");
    wrong.put(header + "5,mover,0,0,0,1,0,0,0\n4,mover,0,0,0,1,0,0,0\n", "frames run backward");
    wrong.put(header + "0,mover,0,0,0,2,0,0,0\n", "norm 2.0");
    wrong.put(header + "0,mover,NaN,0,0,1,0,0,0\n", "x is NaN");
    wrong.put(header + "0.5,mover,0,0,0,1,0,0,0\n", "frame is 0.5");
    wrong.put("frame,body,x,y,z\n0,mover,0,0,0\n", "no column qw");
    for (Map.Entry<String, String> entry : wrong.entrySet()) {
      Files.writeString(file("p.csv"), entry.getKey());
      String line = replay("point", "w").mustRefuse();
      assertTrue(line.contains(entry.getValue()), line);
    }
  }

  @Test
  void passesAreNotTimedIfTheFirstOneMovesBodies() {
    String line = replay("sphere:2", "t", "--repeat", 3).mustRefuse();
    assertTrue(line.contains("a pass would not begin where the last one did: "), line);
    assertTrue(line.contains("--repeat with --poses: "), line);
  }

  @Test
  void aBodyThatMovesGetsBackItsVoxelsButNoOthers() throws IOException {
    String rows =
        "frame,body,segment,i,j,k,solid\n0,mover,mover,21,15,15,0\n3,mover,mover,21,15,15,1\n";
    Path edits = Files.writeString(file("e.csv"), rows + "4,still,still,0,0,0,1\n");
    replay("sphere:2", "e", "--edits", edits).mustSucceed();
    Files.writeString(edits, rows + "4,mover,mover,0,0,0,1\n");
    String line = replay("sphere:2", "e", "--edits", edits).mustRefuse();
    assertTrue(line.startsWith("palpate: a body that moves gains a voxel: mover: "), line);
    assertTrue(line.contains("e.csv frame 4: "), line);
  }
}
