package org.palpate.device;

/**
 * What a device can do, as its maker says.
 *
 * @param name as a person knows it
 * @param serial what tells two of a kind apart; empty where it has none
 * @param maxForceNewton nominal maximum; 0 for a device without force, infinity for one without a
 *     limit
 * @param maxStiffnessNewtonPerMm largest stiffness it renders stably, of its own workspace
 * @param workspaceRadiusMm radius of the ball that the probe reaches
 * @param reportIntervalNanos usual time between samples; 0 where every read is a sample
 */
public record DeviceSpecification(
    String name,
    String serial,
    double maxForceNewton,
    double maxStiffnessNewtonPerMm,
    double workspaceRadiusMm,
    long reportIntervalNanos) {}
