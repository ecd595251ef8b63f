(run with: --machine lathe2 --set #2701=1 --set #2801=2)
O1 (a geometry offset of 1 in X is a diameter)
T0101
G00X50.Z0
#100=#5021
#101=#5022
M30 (finally #100=51, #101=2)
