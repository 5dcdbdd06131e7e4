package org.palpate.examples;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.palpate.device.Trajectory;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.ReplayRun;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Moves a device through a NIfTI volume, off line, and prints the force on the hand. */
public final class TouchOffline {
  /** Takes a file and a segment, for example {@code scan.nii.gz 'bone=>=1500'}. */
  public static void main(String[] args) throws IOException {
    VolumeReader file = VolumeFiles.open(Path.of(args[0]), ReadOptions.defaults());
    SegmentedVolume volume = SegmentBuilder.read(file, List.of(SegmentSpec.parse(args[1])));
    ContactScene scene = new ContactScene(volume, ContactSettings.standard());

    // One sample per millisecond, from a face of the volume to its centre, in grid coordinates.
    VoxelGrid grid = volume.grid();
    Trajectory trajectory = new Trajectory();
    for (int ms = 0; ms <= 1000; ms++) {
      trajectory.add(ms, grid.sizeX() / 2.0, grid.sizeY() * ms / 2000.0, grid.sizeZ() / 2.0);
    }

    ReplayRun.inGrid(scene, trajectory)
        .run(
            (frame, device, point, force, state, freed) -> {
              if (frame % 100 == 0) {
                System.out.println(frame + " ms: " + point + " " + force.length() + " N");
              }
            });
  }
}
