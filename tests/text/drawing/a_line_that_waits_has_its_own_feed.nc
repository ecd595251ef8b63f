(run with: --machine lathe2)
O1 (F of the second block is its own)
G98 G00 X20. Z0.
G01 ,A170. F100 (expect moves: line F100)
X50. Z-40. ,A135. F50 (expect moves: line F50)
M30
