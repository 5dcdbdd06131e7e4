package org.palpate.host;

import java.io.IOException;
import java.nio.file.Path;
import org.palpate.device.Trajectory;
import org.palpate.io.table.TrajectoryCsvReader;

/**
 * Reads a recorded trajectory from its file. Samples at which a mouse jumped to a new place are
 * marked, see {@link Trajectory#markRelocated}.
 */
public final class TrajectoryFile {
  private TrajectoryFile() {}

  /**
   * Reads all samples of a file in their order.
   *
   * @param file a trajectory in the format of docs/formats.md
   * @param checked whether NaN, infinity and times that run backward are refused
   * @return the samples, in the unit of the file
   * @throws IOException if the file is missing or not understood; the message names the line
   */
  public static Trajectory read(Path file, boolean checked) throws IOException {
    Trajectory trajectory = new Trajectory();
    TrajectoryCsvReader.read(file, checked, new Sink(trajectory));
    return trajectory;
  }

  private record Sink(Trajectory trajectory) implements TrajectoryCsvReader.SampleSink {
    @Override
    public void add(
        double timeMs, double x, double y, double z, double qw, double qx, double qy, double qz) {
      trajectory.add(timeMs, x, y, z, qw, qx, qy, qz);
    }

    @Override
    public void markRelocated() {
      trajectory.markRelocated();
    }
  }
}
