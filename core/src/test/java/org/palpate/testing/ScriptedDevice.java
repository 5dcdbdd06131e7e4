package org.palpate.testing;

import java.util.ArrayList;
import java.util.List;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;

/** A device that a test scripts read by read, and that records the written forces and torques. */
public final class ScriptedDevice implements HapticDevice {
  /** The behaviour of a read. */
  public interface Script {
    /** Fills {@code state} and returns the status of read number {@code read}, from 0. */
    ReadStatus read(int read, DeviceState state);
  }

  public final List<Vec3> forces = new ArrayList<>();
  public final List<Vec3> torques = new ArrayList<>();
  public Script script;
  public RuntimeException onWrite;
  public boolean reachable = true;
  public int closed;
  private int reads;

  public ScriptedDevice(Script script) {
    this.script = script;
  }

  /** Returns a device that rests at a position, with a clock of 1 ms a read. */
  public static ScriptedDevice at(double x, double y, double z) {
    return new ScriptedDevice((read, state) -> fresh(state, read, x, y, z));
  }

  /** Fills {@code state} with a new sample. */
  public static ReadStatus fresh(DeviceState state, long timeMs, double x, double y, double z) {
    state.positionMm.set(x, y, z);
    state.timeNanos = timeMs * ManualClock.MS;
    return ReadStatus.FRESH;
  }

  /** Returns the last written force. */
  public Vec3 lastForce() {
    return forces.get(forces.size() - 1);
  }

  /** Forgets the forces and torques that were written, so that a long run does not keep them. */
  public void forgetWritten() {
    forces.clear();
    torques.clear();
  }

  /** Returns the last written torque. */
  public Vec3 lastTorque() {
    return torques.get(torques.size() - 1);
  }

  @Override
  public DeviceSpecification specification() {
    return new DeviceSpecification("scripted", "", 10, 1, 100, 0, true, 200);
  }

  @Override
  public ReadStatus read(DeviceState state) {
    return script.read(reads++, state);
  }

  @Override
  public String ending() {
    return reachable ? "" : "the cable is out";
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    if (onWrite != null) {
      throw onWrite;
    }
    if (!reachable || closed > 0) {
      return false;
    }
    forces.add(new Vec3().set(forceNewton));
    torques.add(new Vec3().set(torqueNewtonMm));
    return true;
  }

  @Override
  public void close() {
    if (closed++ == 0 && reachable) {
      forces.add(new Vec3());
      torques.add(new Vec3());
    }
  }
}
