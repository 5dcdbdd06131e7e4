package org.palpate.benchmarks.stress;

import com.fasterxml.jackson.core.io.NumberOutput;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * A case whose last frame breaks a promise.
 *
 * @param scene the solids
 * @param start the free start of the interaction point
 * @param devices the device position of each frame
 * @param caseSeed the seed of the case
 */
public record FailedCase(HostileScene scene, Vec3 start, List<Vec3> devices, long caseSeed) {

  /** Returns a description for a message. */
  public String summary() {
    return scene.kind()
        + " of "
        + scene.bits().solidCount()
        + " solid voxels, "
        + devices.size()
        + " frames, case seed "
        + caseSeed;
  }

  /**
   * Writes {@code scene.nrrd}, {@code device.csv} and the command that replays them into a folder,
   * which is created.
   */
  public void write(Path folder, String solver) throws IOException {
    Files.createDirectories(folder);
    Files.write(folder.resolve("scene.nrrd"), nrrd());
    Files.writeString(folder.resolve("device.csv"), csv());
    Files.writeString(folder.resolve("replay.txt"), command(solver));
  }

  private byte[] nrrd() {
    BitCube bits = scene.bits();
    String header =
        "NRRD0004\ntype: uint8\ndimension: 3\nencoding: raw\nsizes: "
            + bits.sizeX()
            + " "
            + bits.sizeY()
            + " "
            + bits.sizeZ()
            + "\nspacings: "
            + number(scene.spacingMm().x)
            + " "
            + number(scene.spacingMm().y)
            + " "
            + number(scene.spacingMm().z)
            + "\n\n";
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(header.getBytes(StandardCharsets.US_ASCII));
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          out.write(bits.get(i, j, k) ? 1 : 0);
        }
      }
    }
    return out.toByteArray();
  }

  private String csv() {
    StringBuilder text = new StringBuilder("t_ms,x,y,z\n");
    append(text, 0, start);
    for (int frame = 0; frame < devices.size(); frame++) {
      append(text, frame + 1, devices.get(frame));
    }
    return text.toString();
  }

  private static void append(StringBuilder text, int millis, Vec3 at) {
    text.append(millis).append(',').append(number(at.x)).append(',').append(number(at.y));
    text.append(',').append(number(at.z)).append('\n');
  }

  private String command(String solver) {
    return "palpate replay --volume scene.nrrd --segment solid=nonzero --trajectory device.csv"
        + " --coordinates grid --raw-device --solver "
        + solver
        + " --max-step "
        + number(scene.maxStepMm())
        + " --legs legs.csv --out frames.csv\n";
  }

  private static String number(double value) {
    return NumberOutput.toString(value, true);
  }
}
