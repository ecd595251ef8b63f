(run with: --machine lathe2 --set #2705=2)
O1 (T5 is offset 5 alone)
T5 (expect assumed: turret stays)
G00X50.Z0
#100=#5021
M30
(finally #100=52)
