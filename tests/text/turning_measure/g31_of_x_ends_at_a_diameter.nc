(run with: --machine lathe2 --skip-at X=30)
O1 (Measuring tools)
G98G00X50.Z5.
G31X20.F100 (expect moves: probe X30 Z5)
#100=#5061
M30
(finally #100=30)
