(run with: --machine lathe2)
O1 (G90 is no absolute mode here)
G97S500M03
G18G21G90G99 (expect assumed: turning cycle)
G00X50.Z2.
M30
