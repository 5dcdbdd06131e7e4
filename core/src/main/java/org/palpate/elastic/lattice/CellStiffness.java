package org.palpate.elastic.lattice;

/**
 * The stiffness of the matter in a cell.
 *
 * @param solidModulus the mean modulus, to which air adds nothing, N/mm^2
 * @param restModulus the mean modulus with that of air, N/mm^2
 * @param momentX the second moment along x, over that of a full cell
 * @param momentY the same along y
 * @param momentZ the same along z
 */
public record CellStiffness(
    float solidModulus, float restModulus, float momentX, float momentY, float momentZ) {}
