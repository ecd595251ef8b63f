(run with: --machine lathe2 --skip-at Z=-49.8 --param 6252=4 --param 6255=1 --param 6241=60)
O1 (Measuring tools)
G00X100.Z5.T0202
G50Z55.
G37Z0 (expect moves: rapid Z-46; probe Z-49.8 F60)
#100=#2102
M30
(finally #100=0.2)
