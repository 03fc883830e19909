"""The exercises of the lessons: questions, and hints for mistakes that are often made."""

import math

from answers import Formula, Number, Run

DISK = [(0.1, 1), (0.2, 1), (0.2, 3), (0.5, 0.9)]  # radius of the disk, length scale


def disk_share(c, q):
    half = c * q / (1 + 2 * c * q)
    return 2 * half * math.sqrt(1 - half * half)


LESSONS = {
    1: {
        "predict": Number(
            "Two balls of weight 2 move apart. At which distance d does the neck break?",
            2 * math.sqrt(2),
            {2: "At that distance the two spheres of radius sqrt(w/2) touch; a neck still joins "
                "them. Ask when the edge's weight is zero.",
             4: "A weight is the square of a radius.",
             math.sqrt(2): "That is half of it: d/2 is the distance from the middle to a centre."}),
        "run": Run("How many necks has the skin of crambin, `bench/molecules/1crn.pdb`, "
                   "model vdw?",
                   "info 1crn.pdb", ["necks", "count"]),
        "explain": Formula(
            "Two equal balls of weight w stand at a distance d. Give the neck's radius.", "w d",
            lambda w, d: math.sqrt((w - d * d / 4) / 2), [(2, 2), (2, 1), (5, 3), (0.5, 0.4)],
            {"sqrt(w - d^2/4)": "That is the ball about the middle before it is shrunk.",
             "sqrt(w/2 - d^2/4)": "The whole weight of the middle is halved, the part from the "
                                  "distance too.",
             "sqrt((w - d^2)/2)": "How far is the middle from a centre?"})},
    2: {
        "predict": Number(
            "Which angle, in degrees, do [L] and [U] guarantee with Q = 1.75?",
            math.degrees(math.asin(1 / 1.75 ** 2)),
            {math.degrees(math.asin(1 / 1.75)): "Q stands in [L] and in [U].",
             math.asin(1 / 1.75 ** 2): "Degrees, please.",
             math.degrees(math.asin(1 / 1.65 ** 2)): "That is with the paper's Q."}),
        "run": Run("Mesh `bench/molecules/benzene.pdb`, model vdw, with `-C` 0.05. How many "
                   "triangles?",
                   "mesh benzene.pdb -C 0.05", ["triangles"]),
        "explain": Formula(
            "A ball is covered with equilateral triangles as large as [U] allows. How many are "
            "there, from C and Q, if flat areas are counted?", "C Q",
            lambda c, q: 4 * math.pi / (0.75 * math.sqrt(3) * (c * q) ** 2),
            [(0.08, 1.65), (0.04, 1.65), (0.1, 1.7)],
            {"4*pi / (sqrt(3)/4 * (C*Q)^2)": "C Q rho is the circumradius, not the edge.",
             "4*pi / (sqrt(3)/4 * (2*C*Q)^2)": "An edge is sqrt(3) circumradii long, not two.",
             "1 / (0.75*sqrt(3) * (C*Q)^2)": "What is the area of the ball?"})},
    3: {
        "predict": Number(
            "A skin of one component and genus 3 has 5 minima and 4 maxima. How many saddles?", 13,
            {7: "That is a sphere's sum. Each handle takes two from it.",
             5: "Saddles count negatively.",
             10: "A handle takes two from the sum, not one."}),
        "run": Run("How many saddles has the height along (1, 2, 3) on gramicidin "
                   "(`bench/molecules/1grm_model1.pdb`), model vdw, before anything is cancelled?",
                   "morse 1grm_model1.pdb --function height:1,2,3", ["before", "saddles"]),
        "explain": Formula(
            "The dumbbell's axis stands at an angle phi to V. Give lambda^2 for the candidates of "
            "its neck.", "phi", lambda phi: 0.5 / (1 - 2 * math.cos(phi) ** 2),
            [(math.pi / 2,), (1.3,), (1,), (2,)],
            {"0.5*(1 - 2*cos(phi)^2)": "Put u = lambda M V into u . M u = w/2, and use M M = I.",
             "0.5/(1 - 2*cos(phi)^2)^2": "M M = I: one M is left, not two.",
             "1/(1 - 2*cos(phi)^2)": "The weight of the edge is halved.",
             "0.5": "That is the neck of the dumbbell on its side.",
             "0.5/(1 - 2*cos(phi))": "V . a stands in V . M V twice.",
             "0.5/(1 - 2*sin(phi)^2)": "Standing up, phi is 0."})},
    4: {
        "predict": Number("A skin has 9 saddles. How many arcs has its complex?", 36,
                          {18: "Those are the regions. How many lines leave a saddle?",
                           9: "More than one line leaves a saddle.",
                           72: "An arc has a saddle at one end only."}),
        "run": Run("How many pairs does the program cancel on a protein of a virus, "
                   "`bench/molecules/2buk.pdb.gz`, model vdw?", "morse 2buk.pdb.gz",
                   ["cancelled_pairs"]),
        "explain": Formula(
            "The dumbbell of two balls of weight w at a distance d lies on its side. Give the "
            "persistence of a saddle and a minimum.", "w d",
            lambda w, d: math.sqrt(w / 2) - math.sqrt((w - d * d / 4) / 2),
            [(2, 2), (2, 1), (5, 3)],
            {"sqrt(w/2) + sqrt((w - d^2/4)/2)": "Both lie below the axis.",
             "sqrt(w) - sqrt(w - d^2/4)": "The skin's patches are shrunk: half of each weight.",
             "w/2 - (w - d^2/4)/2": "That is a difference of squares, not of heights."})},
    5: {
        "predict": Number("A front vertex has a bare angle of 140 degrees. How many triangles does "
                          "the program lay there?", 2,
                          {3: "That is the paper's rule, which rounds up.",
                           6: "Six fill the whole turn.",
                           1: "It would have 140 degrees."}),
        "run": Run("How many fans are laid on `bench/molecules/benzene.pdb` with `--fronts` 1?",
                   "mesh benzene.pdb --fronts 1", ["operations", "creep"]),
        "explain": Formula(
            "A bowl of disk radius r is laid on a sphere of radius rho. How long is a rim edge?",
            "r rho", lambda r, rho: r * rho / math.hypot(r, rho), DISK,
            {"r": "That is its length on the disk; it shrinks when its ends drop to the sphere.",
             "r*rho^2/(r^2 + rho^2)": "Both ends are scaled alike, so the edge is scaled once.",
             "r*sqrt(1 - (r/rho)^2)": "The points slide towards the centre, not along the normal "
                                      "at p_0."})},
    6: {
        "predict": Number("A hole of nine edges is closed without a new vertex. How many triangles "
                          "does it take?", 7,
                          {9: "That is a fan about a new vertex.",
                           8: "The last triangle closes three edges at once.",
                           3: "Each triangle but the last takes away one edge only."}),
        "run": Run("How often do fronts touch outside of protecting spheres on "
                   "`bench/molecules/1crn.pdb` with `--fronts` 1 and `--height` 1,2,3?",
                   "mesh 1crn.pdb --fronts 1 --height 1,2,3",
                   ["operations", "guard_outside_protecting"]),
        "explain": Formula(
            "How far below a saddle at a waist are the two branches of the level curve one edge e "
            "apart? To leading order, from rho and e.", "rho e", lambda rho, e: e * e / (8 * rho),
            [(1, 0.1), (2, 0.1), (0.5, 0.04)],
            {"e^2/(2*rho)": "The branches stand at x and at -x.",
             "e^2/(4*rho)": "Each branch is half an edge away, and that is squared.",
             "e/(8*rho)": "The skin falls off with the square of the distance."})},
    7: {
        "predict": Number("What is r_a / rho for C = 0.1 and Q = 1.63?", disk_share(0.1, 1.63),
                          {disk_share(0.1, 1.63) / 2: "That is the closed form as printed, which "
                                                      "lost a factor.",
                           0.1 * 1.63 / (1 + 0.2 * 1.63): "That is half the edge, R.",
                           0.2 * 1.63 / (1 + 0.2 * 1.63): "That is the edge; its end lies lower "
                                                          "than the disk's rim."}),
        "run": Run("Mesh `bench/molecules/caffeine.xyz` with `-C` 0.1 and `-Q` 1.63. How many "
                   "triangles?",
                   "mesh caffeine.xyz -C 0.1 -Q 1.63", ["triangles"]),
        "explain": Formula(
            "A fan triangle has two sides r with an angle phi between them. Give its circumradius.",
            "r phi", lambda r, phi: r / (2 * math.cos(phi / 2)),
            [(0.2, 1), (0.2, 1.3), (1, 0.8), (1, 1.6)],
            {"r/(2*sin(phi/2))": "That is with phi at the tip of the wrong triangle: try phi near "
                                 "0.",
             "r/(2*cos(phi))": "Half the angle: drop the height from the tip.",
             "r*sin(phi/2)": "That is half of the third side."})},
    8: {
        "predict": Number("A closed mesh has 2,100 triangles. After 51 insertions, 4 deletions and "
                          "300 flips, how many?", 2194,
                          {2147: "A new vertex splits one triangle into three.",
                           2241: "One of the three takes the place of the old one.",
                           2202: "A deletion takes triangles away.",
                           2198: "A deletion takes away as many as an insertion brings.",
                           2494: "A flip turns an edge; it makes no triangle."}),
        "run": Run("How many flips does the refinement of `bench/molecules/c60.xyz`, model paper, "
                   "with `-C` 0.05, make?",
                   "mesh c60.xyz --model paper -C 0.05", ["operations", "flip"]),
        "explain": Formula(
            "Give the least Q for which no insertion can break [L], from C.", "C",
            lambda c: 2 * c + math.sqrt(4 * c * c + 2), [(0.08,), (0.04,), (0.2,)],
            {"sqrt(2)": "That is the limit as C goes to zero.",
             "sqrt(2 + 4*C)": "Q stands on both sides of Q^2 > 2 + 4 C Q.",
             "4*C + sqrt(16*C^2 + 2)": "Half of 4 C goes before the root, its square under it."})},
    9: {
        "predict": Number("A skin has three components, of genus 0, 2 and 3. What is its Euler "
                          "characteristic?", -4,
                          {-8: "Each component counts two.",
                           1: "A handle takes two away.",
                           16: "Handles count negatively."}),
        "run": Run("Mesh `bench/molecules/caffeine.xyz` with `--method` marching-cubes. How many "
                   "triangles break [U]? With `--json` the report has it, as violations_U.",
                   "mesh caffeine.xyz --method marching-cubes", ["violations_U"]),
        "explain": Formula(
            "Along the flow G must change by g, and |N| is n at the start. Give the longest "
            "path.", "n g", lambda n, g: n - math.sqrt(n * n - g),
            [(1, 0.1), (1, 0.9), (2, 1), (0.3, 0.05)],
            {"g/(2*n)": "|N| falls along the path, by as much as the path is long.",
             "sqrt(n^2 - g)": "That is what is left of |N| at the end.",
             "n + sqrt(n^2 - g)": "That is the other root."})},
    10: {
        "predict": Number(
            "Were the paper's times linear in the triangles, how many seconds would GramicidinA "
            "take, from those of pdb7tmn?", 5 * 305186 / 24336,
            {202: "That is what it took.",
             5 * 24336 / 305186: "More triangles take longer.",
             305186 / 24336: "That is how many times the triangles there are."}),
        "run": Run("Mesh `bench/molecules/9dna.pdb`, model sas, with `--method` static and `-C` "
                   "0.1. How many triangles?", "mesh 9dna.pdb --model sas --method static -C 0.1",
                   ["triangles"]),
        "explain": Formula(
            "Two meshes of n1 and n2 triangles took t1 and t2. Give the power with which the time "
            "grows.", "n1 t1 n2 t2",
            lambda n1, t1, n2, t2: math.log(t2 / t1) / math.log(n2 / n1),
            [(24336, 5, 305186, 202), (1, 1, 10, 100), (10, 3, 40, 6)],
            {"(t2/t1)/(n2/n1)": "A power is a ratio of logarithms.",
             "log(n2/n1)/log(t2/t1)": "That is the power with which the triangles grow.",
             "log(t2 - t1)/log(n2 - n1)": "Divide the rows, do not subtract them."})},
}
