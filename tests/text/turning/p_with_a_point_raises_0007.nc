(run with: --machine lathe2)
O1 (P of a cycle counts increments)
G97S500M03
G00X46.Z-12.
G75X34.P3.F.08 (expect alarm PS0007 at P3.)
M30
