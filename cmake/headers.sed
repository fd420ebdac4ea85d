# SPDX-License-Identifier: BSD-3-Clause
# Headers as the reference shows them: fstiff::Joint, not fstiff::v0_1::Joint.
s/^(namespace fstiff \{) inline namespace v[0-9_]+ \{/\1/
s/^\}(\}+  \/\/ namespace fstiff)/\1/
