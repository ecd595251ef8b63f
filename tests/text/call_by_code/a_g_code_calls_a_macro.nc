(run with: --param 6050=12)
O1 (CODE-3: G12 calls O9010)
G12 X7.
M30
O9010
#100=#24 (expect #100=7)
M99
