(run with: --machine lathe2)
O1 (Words)
G18G20G40G49G80G99
M30
(finally assumed: none)
