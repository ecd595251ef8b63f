(run with: --machine cartesian-step)
O1 (WCS-7)
G90 G01 X264. F200 (expect moves: line X264)
X264.001 (expect alarm OT0500 says the limit is 264)
M30
