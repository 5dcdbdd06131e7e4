package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.device.DeviceState;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

class TrajectoryCsvReaderTest {
  @TempDir Path folder;

  @Test
  void findsTheQuaternionByNameInAnyOrder() throws IOException {
    Trajectory read = read(true, "qz,x,qx,y,t_ms,qw,z,qy", "0.1,1,0.7,2,0,0.5,3,0.5");
    Quaternion q = read.orientation(0, new Quaternion());
    assertEquals(0.5, q.w, 1e-12);
    assertEquals(0.7, q.x, 1e-12);
    assertEquals(0.5, q.y, 1e-12);
    assertEquals(0.1, q.z, 1e-12);
    assertEquals(1, q.norm(), 1e-15);
  }

  @Test
  void aTableOfFramesIsTheTrajectoryOfItsDevicePoses() throws IOException {
    Trajectory read =
        read(
            true,
            "frame,t_ms,dx,dy,dz,px,py,pz,dqw,dqx,dqy,dqz,pqw,pqx,pqy,pqz",
            "0,5,1,2,3,7,7,7,0.6,0,0.8,0,1,0,0,0");
    DeviceState state = new DeviceState();
    read.read(0, state);
    assertTrue(state.positionMm.sameBits(new Vec3(1, 2, 3)));
    assertTrue(state.orientation.sameBits(new Quaternion(0.6, 0, 0.8, 0)));
  }

  @Test
  void positionsCountBeforeTheDevicePosesOfFrames() throws IOException {
    Trajectory read = read(true, "t_ms,dx,dy,dz,x,y,z", "0,1,2,3,4,5,6");
    DeviceState state = new DeviceState();
    read.read(0, state);
    assertTrue(state.positionMm.sameBits(new Vec3(4, 5, 6)));
  }

  @Test
  void withoutAllFourColumnsTheOrientationIsTheIdentity() throws IOException {
    Trajectory read = read(true, "t_ms,x,y,z,qw,qx,qy", "0,1,2,3,7,7,7");
    assertTrue(read.orientation(0, new Quaternion()).sameBits(new Quaternion()));
  }

  @Test
  void aRoundedQuaternionIsNormalizedAndReadAgainToTheSameBits() throws IOException {
    Trajectory once = read(true, "t_ms,x,y,z,qw,qx,qy,qz", "0,0,0,0,0.5003,-0.5,0.5,0.5");
    Quaternion q = once.orientation(0, new Quaternion());
    assertEquals(1, q.norm(), 1e-15);
    String row = "0,0,0,0," + q.w + "," + q.x + "," + q.y + "," + q.z;
    Trajectory twice = read(true, "t_ms,x,y,z,qw,qx,qy,qz", row);
    assertTrue(twice.orientation(0, new Quaternion()).sameBits(q));
  }

  @Test
  void aQuaternionWhoseNormIsNotOneIsRefusedWithItsLine() {
    for (String q : new String[] {"1.002,0,0,0", "0,0,0,0", "0.998,0,0,0", "1e200,0,0,0"}) {
      CsvFormatException e =
          assertThrows(
              CsvFormatException.class,
              () -> read(true, "t_ms,x,y,z,qw,qx,qy,qz", "0,0,0,0,1,0,0,0", "1,0,0,0," + q));
      assertTrue(e.getMessage().contains("has the norm"), e.getMessage());
      assertTrue(e.getMessage().contains(" line 3:"), e.getMessage());
    }
  }

  @Test
  void anUncheckedQuaternionPassesAsItIs() throws IOException {
    Trajectory read =
        read(false, "t_ms,x,y,z,qw,qx,qy,qz", "0,0,0,0,0,0,0,0", "1,0,0,0,NaN,0,2,-inf");
    assertTrue(read.orientation(0, new Quaternion()).sameBits(new Quaternion(0, 0, 0, 0)));
    Quaternion bad = new Quaternion(Double.NaN, 0, 2, Double.NEGATIVE_INFINITY);
    assertTrue(read.orientation(1, new Quaternion()).sameBits(bad));
  }

  private Trajectory read(boolean checked, String... lines) throws IOException {
    Path file = folder.resolve("t.csv");
    Files.writeString(file, String.join("\n", lines) + "\n");
    Trajectory trajectory = new Trajectory();
    TrajectoryCsvReader.read(file, checked, trajectory::add);
    return trajectory;
  }
}
