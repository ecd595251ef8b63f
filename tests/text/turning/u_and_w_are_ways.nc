(run with: --machine lathe2)
O1 (U and W of system A)
G97S500M03
G00X50.Z0
G01U-10.W-5.F.2 (expect moves: line X40 Z-5 F0.2)
#100=#5001
#101=#5002
M30 (finally #100=40, #101=-5)
