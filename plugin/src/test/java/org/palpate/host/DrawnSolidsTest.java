package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class DrawnSolidsTest {
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(8, 8, 8);

  private final BitCube base = dot(1, 1, 1);
  private final BitCube loose = dot(5, 5, 5);
  private final SegmentedVolume volume =
      new SegmentedVolume(
          GRID, List.of(new Segment("base", base, 0), new Segment("loose", loose, 0)));
  private final Pose turned = new Pose();
  private DrawnSolids solids;
  private DrawnSolids.Probe probe;

  @BeforeEach
  void placeTheLooseSegment() {
    // A quarter turn about z takes the centre (5.5, 5.5, 5.5) to (-5.5, 5.5, 5.5), then 20 up.
    turned.translation.set(0, 0, 20);
    turned.rotation.setRotationVector(new Vec3(0, 0, Math.PI / 2));
    solids = new DrawnSolids(volume, List.of(RigidTransform.identity(), transform(turned)));
    probe = new DrawnSolids.Probe(solids);
    probe.refresh();
  }

  private static BitCube dot(int i, int j, int k) {
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(i, j, k);
    return bits;
  }

  private static RigidTransform transform(Pose pose) {
    return pose.transform(RigidTransform.identity());
  }

  @Test
  void aRayMeetsASegmentWhereItIsDrawnAndNotWhereItRests() {
    Vec3 above = new Vec3(-5.5, 5.5, 30);
    Vec3 below = new Vec3(-5.5, 5.5, 10);
    assertEquals(0.2, probe.firstHit(above, below).orElseThrow(), 1e-9, "at z = 26");
    assertEquals(Optional.of("loose"), probe.firstName(above, below));
    assertTrue(probe.firstHit(new Vec3(5.5, 5.5, 30), new Vec3(5.5, 5.5, -9)).isEmpty());
  }

  @Test
  void theNearestOfSeveralSegmentsIsMetFirst() {
    Vec3 nearBase = new Vec3(1.5, 1.5, 0);
    Vec3 nearLoose = new Vec3(-5.5, 5.5, 25.5);
    assertEquals(Optional.of("base"), probe.firstName(nearBase, nearLoose));
    assertEquals(Optional.of("loose"), probe.firstName(nearLoose, nearBase));
  }

  @Test
  void voxelsAroundAPointHaveTheirCentresWhereTheyAreDrawn() {
    List<Vec3> centres = new ArrayList<>();
    probe.around(new Vec3(-5, 5, 26), 1, 1, centres::add);
    assertEquals(1, centres.size());
    assertEquals(0, centres.get(0).sub(new Vec3(-5.5, 5.5, 25.5), new Vec3()).length(), 1e-12);
    centres.clear();
    probe.around(new Vec3(5.5, 5.5, 5.5), 1, 1, centres::add);
    assertEquals(List.of(), centres, "nothing is drawn at the rest position");
  }

  @Test
  void publishedPosesOfMovableBodiesAreFollowed() {
    Body fixed = new Body("base", base, GRID, Mobility.FIXED);
    Body moved = new Body("loose", loose, GRID, Mobility.MOVABLE);
    moved.setPose(turned);
    BodyScene bodies = new BodyScene(List.of(fixed, moved));
    RigidScene scene =
        new RigidScene(
            bodies,
            ToolSampler.point(),
            MovableShapes.ofPoints(bodies),
            RigidSettings.of(8, Clearance.POINTS));
    TouchProperties properties = new TouchProperties(new Accumulator());
    ToolPublisher publisher = new ToolPublisher(properties, GRID, bodies);
    moved.setPose(new Pose());
    publisher.publish(new Pose(), new RigidSolver(scene).newMotion(), new Vec3(), new Vec3(), 0);
    properties.accumulator().take();
    assertTrue(publisher.bodyPose(0).isEmpty(), "a fixed body has no pose to follow");
    solids.follow(publisher, Optional.empty());
    probe.refresh();
    assertEquals(
        Optional.of("loose"), probe.firstName(new Vec3(5.5, 5.5, 9), new Vec3(5.5, 5.5, 0)));
  }
}
