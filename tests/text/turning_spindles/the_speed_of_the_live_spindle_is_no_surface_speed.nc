(run with: --machine lathe3c)
O1 (Spindles)
G50S3000
G96S200M03
M05
S1500M133
G01X40.F.1
M135
M03S180
M30
(finally records: spindle cw 200; spindle stop; live spindle cw 1500; live spindle stop; spindle cw 180)
