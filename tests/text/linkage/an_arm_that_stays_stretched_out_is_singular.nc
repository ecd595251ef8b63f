(run with: --machine arm4)
O0001 (an arc of 264 mm about the shoulder: the rates of the joints are determined nowhere)
G03 X0 Y264. I-264. F600. (expect alarm SINGULAR says stretched out) (expect moves: none)
M30
(finally machine X264 Y0)
