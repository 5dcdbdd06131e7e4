/**
 * Finite elements on a control lattice: corotational hexahedra with incompatible modes, without an
 * assembled matrix, and conjugate gradients with a multigrid preconditioner.
 *
 * <p>Uses {@code volume} and {@code geometry}. An instance belongs to one thread; nothing is
 * allocated after construction. Displacements are millimetres along the axes of the grid, forces
 * newtons, moduli N/mm^2. A vector holds the x of every node, then the y, then the z.
 */
package org.palpate.elastic.lattice;
