package org.palpate.examples;

import java.util.List;
import org.palpate.device.HapticDevice;
import org.palpate.edit.VoxelEdit;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SessionSettings;
import org.palpate.host.TouchSession;
import org.palpate.loop.LoopReport;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Everything that a volume platform needs: labels and edits in, the interaction point out. */
final class MinimalHost implements AutoCloseable {
  private static final int BONE_RGB = 0xE6C99F;

  private final ContactScene scene;
  private final TouchSession session;
  private final Vec3 point = new Vec3();

  /** Makes the voxels of one label solid; x runs fastest in {@code labels}. */
  MinimalHost(byte[] labels, int label, int edge, Vec3 spacingMm, HapticDevice device) {
    BitCube bone = new BitCube(edge, edge, edge);
    for (int n = 0; n < labels.length; n++) {
      if (labels[n] == label) {
        bone.set(n % edge, n / edge % edge, n / edge / edge);
      }
    }
    VoxelGrid grid = new VoxelGrid(edge, edge, edge, spacingMm, RigidTransform.identity());
    List<Segment> segments = List.of(new Segment("bone", bone, BONE_RGB));
    scene = new ContactScene(new SegmentedVolume(grid, segments), ContactSettings.standard());
    session = new TouchSession(scene, device, SessionSettings.standard());
  }

  /** Starts the haptic thread; force comes on after a warm-up of one to two seconds. */
  void start() {
    session.start();
  }

  /** Updates the point; one thread calls it 30 times a second. Returns false after the end. */
  boolean tick() {
    session.takeUpdates();
    session.properties().touch().interactionPoint(point);
    scene.grid().gridToWorld(point, point);
    return !session.supervise();
  }

  /** Returns the interaction point at the last tick, world mm. */
  Vec3 pointWorldMm() {
    return point;
  }

  /** Returns the number of frames so far. */
  long frames() {
    return session.status().frames();
  }

  /** Makes a voxel solid or empty in one of the next frames; false if the queue is full. */
  boolean paint(int i, int j, int k, boolean solid) {
    return scene.edits().offer(new VoxelEdit(0, i, j, k, solid));
  }

  /** Whether the haptic thread has applied every edit. */
  boolean isPainted() {
    return scene.edits().isIdle();
  }

  /** Ends the session with zero force, and returns what it measured. */
  LoopReport end() {
    session.stop();
    return session.report();
  }

  @Override
  public void close() {
    session.close();
  }
}
