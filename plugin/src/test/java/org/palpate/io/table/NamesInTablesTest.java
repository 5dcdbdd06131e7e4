package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.EditQueue;
import org.palpate.edit.EditSchedule;
import org.palpate.edit.VoxelWriter;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class NamesInTablesTest {
  private static final String NAME = "jaw, \"left\"";

  @TempDir Path folder;

  @Test
  void editsOfASegmentWithACommaAndQuotesAreReadAsTheyWereWritten() throws IOException {
    Path file = folder.resolve("edits.csv");
    try (OutputStream stream = Files.newOutputStream(file)) {
      EditsCsv.add(EditsCsv.writer(stream), 0, NAME, 1, 2, 3, true);
    }
    BitCube other = new BitCube(4, 4, 4);
    BitCube bits = new BitCube(4, 4, 4);
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(4, 4, 4);
    EditSchedule edits = EditsCsv.read(file, List.of("jaw", NAME), List.of(grid, grid));
    EditQueue queue = new EditQueue(grid, 2);
    edits.offerUpTo(0, queue);
    VoxelWriter writer =
        new VoxelWriter(new CollisionScene(List.of(other, bits)), (segment, box) -> {});
    queue.applyTo(writer, Integer.MAX_VALUE);
    assertTrue(bits.get(1, 2, 3));
    assertFalse(other.get(1, 2, 3));
  }

  @Test
  void posesOfABodyWithACommaAndQuotesAreReadAsTheyWereWritten() throws IOException {
    Path file = folder.resolve("poses.csv");
    String row = "7," + CsvWriter.quoted(NAME) + ",1,2,3,1,0,0,0\n";
    Files.writeString(file, "frame,body,x,y,z,qw,qx,qy,qz\n" + row);
    List<BodyPose> poses = PosesCsv.read(file, List.of("jaw", NAME));
    assertEquals(1, poses.size());
    assertEquals(1, poses.get(0).body());
    assertEquals(3, poses.get(0).restToPresent().translation.z);
  }
}
