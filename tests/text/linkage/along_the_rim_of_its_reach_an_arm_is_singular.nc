(run with: --machine arm4)
O0001 (from the stretched arm an arc leaves along the rim: its joints would have to begin with a jump of their speed)
G03 X214. Y50. I-50. F600. (expect alarm SINGULAR says stretched out) (expect moves: none)
M30
(finally machine X264 Y0)
