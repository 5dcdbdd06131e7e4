/**
 * The OpenCL backend of the collision port: judges the legs of a rigid tool's points on a device,
 * with the same verdicts as the CPU.
 *
 * <p>Uses {@code collision} and what lies below it. Classes of JOCL are loaded only if somebody
 * asks for OpenCL. One thread at a time uses a device; judging allocates nothing. Positions are
 * grid coordinates of a body, or of the cells of its grown solids.
 */
package org.palpate.opencl;
