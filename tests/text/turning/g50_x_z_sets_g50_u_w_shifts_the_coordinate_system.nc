(run with: --machine lathe2)
O1 (G50 X Z sets, G50 U W shifts the coordinate system)
G97S500M03
G00X60.Z5.
G50X50.Z0
#100=#5001
G00X52.Z2.
#101=#5021
#102=#5022
G50U2.W-1.
#103=#5001
#104=#5002
M30
(finally #100=50, #101=62, #102=7, #103=54, #104=1)
