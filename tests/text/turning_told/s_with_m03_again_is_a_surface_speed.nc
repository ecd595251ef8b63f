(run with: --machine lathe2)
O1 (Spindle and feed)
G50S3000
G96S150M03
S800M03
M30
(finally records: spindle cw 150; spindle cw 800)
