(run with: --machine lathe2)
O1 (Spindle and feed)
G50X100.
G96S100M03 (expect assumed: it lies at X-100 of the machine)
M30
