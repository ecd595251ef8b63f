(run with: --set #13001=5)
O1 (CRC-1: start in a G00 or G01 block)
G41 D1 G02 X5. Y5. R5. F100 (expect alarm PS0034)
M30
