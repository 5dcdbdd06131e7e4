package org.palpate.elastic.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.volume.BitCube;

/** The matter in a window that moves while voxels are edited. */
class WindowLatticeTest {
  private static final double NEWTON_PER_MM2 = 0.01;

  /** The voxels of a cell of the window. */
  private static final double VOXELS = 8;

  /** Contacts in cells of the lattice; the edited voxel lies in the window at the first alone. */
  private static final double[] NEAR = {8.5, 6, 6};

  private static final double[] FAR = {15, 6, 6};

  private final BitCube bits = new BitCube(40, 20, 20);
  private final ControlLattice session;
  private final ControlLattice replay;

  WindowLatticeTest() {
    for (int voxel = 0; voxel < 36 * 16 * 16; voxel++) {
      bits.set(2 + voxel % 36, 2 + voxel / 36 % 16, 2 + voxel / 36 / 16);
    }
    session = lattice();
    replay = lattice();
  }

  private ControlLattice lattice() {
    ElasticSegment soft = new ElasticSegment(bits, new ElasticMaterial(1e4, 0.3));
    return new ControlLattice(
        new GridMetric(1, 1, 1), List.of(soft), List.of(), 4, OptionalDouble.of(4));
  }

  private static void move(ControlLattice lattice, double[] at) {
    assertTrue(lattice.window().orElseThrow().moveTo(at));
  }

  /** Returns the solid voxels that the window counts. */
  private static double solid(ControlLattice lattice) {
    LatticeMatter matter = lattice.window().orElseThrow().matter();
    double sum = 0;
    for (int cell = 0; cell < matter.cells().count(); cell++) {
      sum += VOXELS * matter.restModulus(cell) / NEWTON_PER_MM2;
    }
    return sum;
  }

  @Test
  void aMoveCountsNoEditThatWasNotRead() {
    move(session, NEAR);
    double full = solid(session);
    move(session, FAR);
    bits.clear(20, 10, 10);
    move(session, NEAR);
    assertEquals(full, solid(session));
    session.refill(session.editedCell(20, 10, 10));
    assertEquals(full - 1, solid(session), 1e-3);
    move(session, FAR);
    move(session, NEAR);
    assertEquals(full - 1, solid(session), 1e-3);
  }

  /** Edits come at their frames, and a field is computed when it comes into use, after those. */
  @Test
  void aReplayThatEditsEarlierCountsAsTheSession() {
    move(session, NEAR);
    move(replay, FAR);
    bits.clear(20, 10, 10);
    move(replay, NEAR);
    assertEquals(solid(session), solid(replay));
    Map<Integer, CellStiffness> recorded = new HashMap<>();
    session.refill(session.editedCell(20, 10, 10), recorded::put);
    recorded.forEach(replay::refill);
    for (double[] at : new double[][] {FAR, NEAR}) {
      move(session, at);
      move(replay, at);
      assertEquals(solid(session), solid(replay));
    }
    bits.set(20, 10, 10);
    session.refill(session.editedCell(20, 10, 10));
    assertEquals(solid(replay) + 1, solid(session), 1e-3);
  }
}
