"""Solvation energies of charges in a ball, in closed form: what the solver is tried against."""

import numpy as np
from scipy.special import eval_legendre, spherical_kn

from poisson_boltzmann import COULOMB, INNER, KAPPA, OUTER


def born(radius, charge=1.0, outer=OUTER, kappa=KAPPA):
    """kJ/mol, of a charge in the centre (Born 1920; with salt, Debye and Hueckel 1923)."""
    return COULOMB / 2 * charge**2 / radius * (1 / (outer * (1 + kappa * radius)) - 1 / INNER)


def kirkwood(radius, places, charges, outer=OUTER, kappa=KAPPA, terms=60):
    """kJ/mol, of charges anywhere in a ball about 0 (Kirkwood 1934). Of degree n inside, the
    field that answers is b times that of the charges, the one outside A k_n(kappa r); both the
    potential and the flux are continuous.

    @param terms  enough for charges up to half the radius from the centre"""
    d = np.linalg.norm(places, axis=1)
    product = np.outer(d, d)
    cosine = np.divide(places @ places.T, product, out=np.ones_like(product), where=product > 0)
    total = 0
    for n in range(terms):
        fall = -(n + 1)  # r k'(r) / k(r), the derivative by log r
        if kappa:
            x = kappa * radius
            fall = x * spherical_kn(n, x, derivative=True) / spherical_kn(n, x)
        b = (n + 1 + fall * outer / INNER) / (INNER * n - outer * fall)
        total += b * (np.outer(charges, charges) * (product / radius**2)**n
                      * eval_legendre(n, np.clip(cosine, -1, 1))).sum()
    return COULOMB / 2 / radius * total
