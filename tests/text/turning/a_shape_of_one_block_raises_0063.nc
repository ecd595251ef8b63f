(run with: --machine lathe2)
O1 (P is Q)
G97S500M03
G00X100.Z2.
G71U2.R1.
G71P10Q10F.3 (expect alarm PS0063 at Q10)
N10G00X40.
M30
